#include "core/base/package_uri.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/robot/urdf_reader.h"

namespace heft {
namespace {

using Colours = std::map<std::string, Eigen::Vector4d>;

class VisualReader {
 public:
  VisualReader(const std::string& file, const std::filesystem::path& baseFolder, Findings& findings)
      : file_(file), baseFolder_(baseFolder), findings_(findings) {}

  std::map<std::string, std::vector<Visual>> read(const XmlElement& robot) {
    collectColours(robot);
    std::map<std::string, std::vector<Visual>> visuals;
    for (const XmlElement& link : robot.children) {
      if (link.name != "link") continue;
      // A named colour may stand in any link's visual and be used in another one.
      for (const XmlElement& visual : link.children) {
        if (visual.name == "visual") collectColours(visual);
      }
    }
    for (const XmlElement& link : robot.children) {
      if (link.name != "link") continue;
      std::vector<Visual>& list = visuals[std::string(link.attributeOr("name"))];
      for (const XmlElement& element : link.children) {
        if (element.name != "visual") continue;
        if (auto visual = readOne(element, link.attributeOr("name"))) list.push_back(*visual);
      }
    }
    return visuals;
  }

  /// A visual, or a collision, which has the same form.
  std::optional<Visual> readOne(const XmlElement& element, std::string_view link) {
    Visual visual;
    if (const XmlElement* origin = element.child("origin")) {
      const auto xyz =
          origin->attribute("xyz") ? parseNumbers(origin->attributeOr("xyz"), 3) : std::vector{0.0, 0.0, 0.0};
      const auto rpy =
          origin->attribute("rpy") ? parseNumbers(origin->attributeOr("rpy"), 3) : std::vector{0.0, 0.0, 0.0};
      if (!xyz || !rpy) {
        warn(*origin, "bad_visual", heft::say("the origin of a visual of link \"{}\" is not three numbers each", link),
             heft::say("The visual is not drawn"));
        return std::nullopt;
      }
      visual.X_LV = poseFromXyzRpy(Vector3d(xyz->data()), Vector3d(rpy->data()));
    }
    const XmlElement* geometry = element.child("geometry");
    if (!geometry || geometry->children.empty()) {
      warn(element, "bad_visual", heft::say("a visual of link \"{}\" has no geometry", link),
           heft::say("It is not drawn"));
      return std::nullopt;
    }
    if (!readGeometry(geometry->children.front(), link, visual)) return std::nullopt;
    readColour(element, link, visual);
    return visual;
  }

 private:
  void warn(const XmlElement& where, const char* code, std::string text, std::string remedy) {
    findings_.push_back(findingAt(where, file_, Severity::warning, code, std::move(text), std::move(remedy)));
  }

  void collectColours(const XmlElement& parent) {
    for (const XmlElement& material : parent.children) {
      if (material.name != "material") continue;
      const auto rgba = colourOf(material);
      if (rgba) colours_.emplace(material.attributeOr("name"), *rgba);
    }
  }

  static std::optional<Eigen::Vector4d> colourOf(const XmlElement& material) {
    const XmlElement* colour = material.child("color");
    if (!colour) return std::nullopt;
    const auto numbers = parseNumbers(colour->attributeOr("rgba"), 4);
    if (!numbers) return std::nullopt;
    return Eigen::Vector4d(numbers->data()).cwiseMax(0.0).cwiseMin(1.0);
  }

  bool readGeometry(const XmlElement& shape, std::string_view link, Visual& visual) {
    if (shape.name == "mesh") return readMesh(shape, link, visual);
    std::vector<double> size;
    const auto add = [&](const char* attribute, std::size_t count) {
      const auto numbers = parseNumbers(shape.attributeOr(attribute), count);
      if (numbers) size.insert(size.end(), numbers->begin(), numbers->end());
    };
    std::size_t expected = 0;
    if (shape.name == "box") {
      visual.kind = Visual::Kind::box;
      add("size", expected = 3);
    } else if (shape.name == "cylinder") {
      visual.kind = Visual::Kind::cylinder;
      expected = 2;
      add("radius", 1);
      add("length", 1);
    } else if (shape.name == "sphere") {
      visual.kind = Visual::Kind::sphere;
      add("radius", expected = 1);
    } else {
      warn(shape, "unknown_geometry", heft::say("link \"{}\" has a visual of unknown shape <{}>", link, shape.name),
           heft::say("It is not drawn; a URDF knows box, cylinder, sphere and mesh"));
      return false;
    }
    bool positive = size.size() == expected;
    for (const double number : size) positive = positive && number > 0.0;
    if (!positive) {
      warn(shape, "bad_visual",
           heft::say("the {} of link \"{}\" needs {} positive number(s)", shape.name, link, expected),
           heft::say("It is not drawn"));
      return false;
    }
    size.resize(3, 0.0);
    visual.size = Vector3d(size.data());
    return true;
  }

  bool readMesh(const XmlElement& shape, std::string_view link, Visual& visual) {
    visual.kind = Visual::Kind::mesh;
    if (shape.attribute("scale")) {
      const auto scale = parseNumbers(shape.attributeOr("scale"), 3);
      if (!scale || Vector3d(scale->data()).cwiseAbs().minCoeff() == 0.0) {
        warn(shape, "bad_visual",
             heft::say("the scale of a mesh of link \"{}\" is not three numbers other than 0", link),
             heft::say("The mesh is not drawn"));
        return false;
      }
      visual.size = Vector3d(scale->data());
    }
    const std::string uri(shape.attributeOr("filename"));
    if (uri.empty()) {
      warn(shape, "bad_visual", heft::say("a mesh of link \"{}\" has no filename", link), heft::say("It is not drawn"));
      return false;
    }
    if (const auto found = resolveUri(uri, baseFolder_)) {
      visual.file = *found;
      return true;
    }
    const bool package = uri.starts_with("package://") || uri.starts_with("model://");
    warn(shape, "mesh_missing", heft::say("mesh \"{}\" of link \"{}\" is not found", uri, link),
         package ? heft::say("Put the package's folder above the URDF or name its parent in ROS_PACKAGE_PATH; motion "
                             "is not affected")
                 : heft::say("It is looked for from \"{}\"; motion is not affected", displayName(baseFolder_)));
    return false;
  }

  void readColour(const XmlElement& element, std::string_view link, Visual& visual) {
    const XmlElement* material = element.child("material");
    if (!material) return;
    if (const auto own = colourOf(*material)) {
      visual.rgba = *own;
      visual.hasColour = true;
      return;
    }
    if (const XmlElement* colour = material->child("color")) {
      warn(*colour, "bad_colour", heft::say("a colour of link \"{}\" is not four numbers", link),
           heft::say("Grey is used"));
      return;
    }
    const auto named = colours_.find(std::string(material->attributeOr("name")));
    if (named != colours_.end()) {
      visual.rgba = named->second;
      visual.hasColour = true;
    } else if (!material->child("texture")) {
      warn(*material, "bad_colour",
           heft::say("material \"{}\" of link \"{}\" is defined nowhere", material->attributeOr("name"), link),
           heft::say("Grey is used"));
    }
  }

  const std::string& file_;
  const std::filesystem::path& baseFolder_;
  Findings& findings_;
  Colours colours_;
};

}  // namespace

std::map<std::string, std::vector<Visual>> readVisuals(const XmlElement& robot, const std::string& file,
                                                       const std::filesystem::path& baseFolder, Findings& findings) {
  return VisualReader(file, baseFolder, findings).read(robot);
}

std::map<std::string, std::vector<Visual>> readCollisions(const XmlElement& robot, const std::string& file,
                                                          const std::filesystem::path& baseFolder) {
  Findings unsaid;
  VisualReader reader(file, baseFolder, unsaid);
  std::map<std::string, std::vector<Visual>> out;
  for (const XmlElement& link : robot.children) {
    if (link.name != "link") continue;
    auto& list = out[std::string(link.attributeOr("name"))];
    for (const XmlElement& element : link.children) {
      if (element.name != "collision") continue;
      const auto body = reader.readOne(element, link.attributeOr("name"));
      if (!body) {
        list.clear();
        break;
      }
      list.push_back(*body);
    }
  }
  return out;
}

}  // namespace heft
