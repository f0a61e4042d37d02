#include "resources/robots/panda/generator/glb.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

namespace heft::panda_maker {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian and is written as memory stands");

struct Look {
  const char* name;
  const char* colour;  ///< Linear light, red green blue.
  const char* roughness;
};

Look lookOf(Material material) {
  switch (material) {
    case Material::shell:
      return {"shell", "0.855,0.855,0.838", "0.3"};
    case Material::dark:
      return {"dark", "0.0262,0.0273,0.0296", "0.45"};
    case Material::metal:
      return {"metal", "0.440,0.456,0.474", "0.35"};
    case Material::sensor:
      return {"sensor", "0.0545,0.0585,0.0640", "0.4"};
  }
  return {};
}

template <class T>
void append(std::string& out, const T& value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

void pad(std::string& out, char fill) {
  while (out.size() % 4) out += fill;
}

class Writer {
 public:
  void add(const Part& part) {
    const Surface& s = part.surface;
    const bool small = s.vertices.size() < 65536;
    std::array<float, 3> low = s.vertices.front(), high = low;
    for (const auto& v : s.vertices) {
      for (int k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], v[k]);
        high[k] = std::max(high[k], v[k]);
      }
    }
    const std::size_t first = accessors_.size();
    begin();
    for (const auto& v : s.vertices) append(bytes_, v);
    accessor(34962, 5126, s.vertices.size(), "VEC3",
             fmt::format(",\"min\":[{},{},{}],\"max\":[{},{},{}]", low[0], low[1], low[2], high[0], high[1], high[2]));
    begin();
    for (const auto& n : s.normals) append(bytes_, n);
    accessor(34962, 5126, s.normals.size(), "VEC3", "");
    begin();
    for (const auto& t : s.triangles) {
      for (const unsigned corner : t) {
        if (small) {
          append(bytes_, static_cast<std::uint16_t>(corner));
        } else {
          append(bytes_, static_cast<std::uint32_t>(corner));
        }
      }
    }
    accessor(34963, small ? 5123 : 5125, 3 * s.triangles.size(), "SCALAR", "");
    const Look look = lookOf(part.material);
    join(primitives_, fmt::format(R"({{"attributes":{{"POSITION":{},"NORMAL":{}}},"indices":{},"material":{}}})", first,
                                  first + 1, first + 2, materialCount_++));
    join(materials_,
         fmt::format(R"({{"name":"{}","pbrMetallicRoughness":{{"baseColorFactor":[{},1],"metallicFactor":0,)"
                     R"("roughnessFactor":{}}}}})",
                     look.name, look.colour, look.roughness));
  }

  std::string finish(const std::string& name) {
    std::string views, accessors;
    for (const std::string& view : views_) join(views, view);
    for (const std::string& entry : accessors_) join(accessors, entry);
    std::string json = fmt::format(
        R"({{"asset":{{"version":"2.0","generator":"make_panda"}},"scene":0,"scenes":[{{"nodes":[0]}}],)"
        R"("nodes":[{{"name":"{}","mesh":0}}],"meshes":[{{"name":"{}","primitives":[{}]}}],"materials":[{}],)"
        R"("accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}}}]}})",
        name, name, primitives_, materials_, accessors, views, bytes_.size());
    pad(json, ' ');
    pad(bytes_, '\0');
    std::string out = "glTF";
    append(out, std::uint32_t{2});
    append(out, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + bytes_.size()));
    append(out, static_cast<std::uint32_t>(json.size()));
    out += "JSON" + json;
    append(out, static_cast<std::uint32_t>(bytes_.size()));
    out += std::string("BIN\0", 4) + bytes_;
    return out;
  }

 private:
  static void join(std::string& list, const std::string& item) { list += (list.empty() ? "" : ",") + item; }
  void begin() {
    pad(bytes_, '\0');
    start_ = bytes_.size();
  }
  void accessor(int target, int type, std::size_t count, const char* shape, const std::string& bounds) {
    views_.push_back(fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{},"target":{}}})", start_,
                                 bytes_.size() - start_, target));
    accessors_.push_back(fmt::format(R"({{"bufferView":{},"componentType":{},"count":{},"type":"{}"{}}})",
                                     views_.size() - 1, type, count, shape, bounds));
  }

  std::string bytes_, primitives_, materials_;
  std::vector<std::string> views_, accessors_;
  std::size_t start_ = 0;
  int materialCount_ = 0;
};

}  // namespace

std::string glb(const std::string& name, const std::vector<Part>& parts) {
  Writer writer;
  for (const Part& part : parts) {
    if (!part.surface.triangles.empty()) writer.add(part);
  }
  return writer.finish(name);
}

}  // namespace heft::panda_maker
