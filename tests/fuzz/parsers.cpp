#include "tests/fuzz/parsers.h"

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/json_file.h"
#include "core/collision/room.h"
#include "core/exporters/controller_file.h"
#include "core/exporters/urdf_copy.h"
#include "core/import/import.h"
#include "core/import/json_numbers.h"
#include "core/import/message_definition.h"
#include "core/live/bridge.h"
#include "core/live/field_mapper.h"
#include "core/live/rdt_protocol.h"
#include "core/live/rtde_protocol.h"
#include "core/live/sources.h"
#include "core/mesh/mesh.h"
#include "core/payload/shape.h"
#include "core/recording/csv_reader.h"
#include "core/robot/robot_model.h"
#include "core/simulation/lesson.h"
#include "core/workspace/session.h"

namespace heft::fuzz {
namespace {

/// What a parser accepts has to be sound: a wrong number is worse than an error.
void require(bool sound) {
  if (!sound) std::abort();
}

/// The bytes as a file of the same name again and again; removed when the program ends. In memory where the system has
/// such a place: on a disk making and removing files takes half of the time.
const std::filesystem::path& asFile(std::string_view bytes, const std::string& ending = "") {
  static struct Folder {
    std::filesystem::path path = place() / ("heft-fuzz-" + std::to_string(::getpid()));
    std::filesystem::path file;
    static std::filesystem::path place() {
      const std::filesystem::path memory = "/dev/shm";
      return ::access(memory.c_str(), W_OK) == 0 ? memory : std::filesystem::temp_directory_path();
    }
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() {
      std::error_code code;
      std::filesystem::remove_all(path, code);
    }
  } folder;
  folder.file = folder.path / ("input" + ending);
  std::error_code none;
  std::filesystem::remove(folder.file, none);
  std::ofstream(folder.file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return folder.file;
}

void checkRecordingRead(const Recording& recording) {
  require(recording.time.allFinite() && recording.wrench.allFinite() && recording.q.allFinite());
  require(recording.dq.allFinite() && recording.position.allFinite() && recording.quaternion.allFinite());
  for (Eigen::Index k = 1; k < recording.rows() && recording.meta.kind == RecordingKind::motion; ++k)
    require(recording.time(k) > recording.time(k - 1));
}

/// Any file, as `heft convert` opens it: told by its content, read, joined, checked.
void recording(std::string_view bytes) {
  const auto& file = asFile(bytes);
  (void)inspectRecording(file);
  if (const auto read = openRecording(file)) checkRecordingRead(read->recording);
}

/// A file that is taken for one of `kind`, whatever its beginning says; all fields are read, and in this process, so
/// that a fuzzer sees what is reached.
template <FileKind kind>
void streamsOf(std::string_view bytes) {
  const auto all = [](const Stream&, std::size_t) { return true; };
  const auto& file = asFile(bytes);
  const auto read =
      kind == FileKind::hdf5 ? readHdf5StreamsHere(file, all, {}, {}) : readStreams(file, kind, all, {}, {});
  if (!read) return;
  for (const Stream& stream : read->streams) {
    for (const auto stamp : stream.stamps) require(isSoundStamp(stamp));
    for (const auto received : stream.received) require(isSoundStamp(received));
  }
}

void csv(std::string_view bytes) {
  if (const auto read = parseRecording(bytes, "input.csv", {})) checkRecordingRead(read->recording);
}

void meta(std::string_view bytes) {
  Findings findings;
  const auto read = parseMeta(bytes, "input.meta.json", "/tmp", findings);
  if (read) require(read->gravity.allFinite() && read->mount.xyz.allFinite() && read->mount.rpy.allFinite());
}

/// The type's name in the first line, its definition up to a zero byte, then a message.
void messages(std::string_view bytes) {
  const auto line = bytes.find('\n'), zero = bytes.find('\0');
  if (line == std::string_view::npos || zero == std::string_view::npos || zero < line) return;
  for (const auto encoding : {MessageEncoding::ros1, MessageEncoding::cdr}) {
    auto decoder = MessageDecoder::make(bytes.substr(0, line), bytes.substr(line + 1, zero - line - 1), encoding);
    if (!decoder) continue;
    for (int again = 0; again < 2; ++again)
      if (decoder->decode(bytes.substr(zero + 1))) require(decoder->names().size() == decoder->values().size());
  }
}

void map(std::string_view bytes) { (void)readMapFile(asFile(bytes)); }

Result<Shape> shapeOf(std::string_view bytes) {
  auto read = parseShape(std::string(bytes));
  if (!read)
    if (const auto json = parseJson(bytes, "shape.json")) read = shapeFromJson(*json, "shape.json", "/nonexistent");
  return read;
}

void shape(std::string_view bytes) {
  const auto read = shapeOf(bytes);
  if (!read) return;
  for (const ShapeBody& body : read->bodies) require(body.X_SB.matrix().allFinite());
}

/// Filling a shape with points takes a millisecond; reading it hardly anything.
void shapePoints(std::string_view bytes) {
  const auto read = shapeOf(bytes);
  if (!read) return;
  Findings findings;
  if (const auto samples = sampleShape(*read, findings))
    for (const auto& body : *samples) require(body.unitPseudoInertia.allFinite() && body.weights.allFinite());
}

void payload(std::string_view bytes) {
  const auto json = parseJson(bytes, "payload.json");
  if (!json) return;
  (void)partialPayloadFromJson(*json, "payload.json");
  if (const auto read = controllerPayloadFromJson(*json, "payload.json"))
    require(std::isfinite(read->mass) && read->com.allFinite() && read->inertiaCom.allFinite());
  if (const auto read = payloadFromJson(*json, "payload.json"))
    require(std::isfinite(read->mass) && read->com.allFinite() && read->inertiaCom.allFinite());
}

void urdf(std::string_view bytes) {
  Findings findings;
  const auto robot = RobotModel::fromUrdfText(std::string(bytes), "/nonexistent", findings);
  if (!robot) return;
  const VectorXd q = VectorXd::Zero(robot->dof());
  for (std::size_t i = 0; i < robot->links().size(); ++i)
    require(robot->linkPose(q, static_cast<int>(i)).matrix().allFinite());
}

/// A robot's file that a payload is written into: what comes out is a URDF as long as what went in was one.
void urdfCopy(std::string_view bytes) {
  const std::string given(bytes);
  FlangePayload payload;
  payload.input.payload = {1.2, {0.01, -0.02, 0.07}, 1e-3 * Matrix3d::Identity()};
  for (const char* const link : {"tool0", "flange", "l1"}) {
    Findings findings;
    const auto written = payloadIntoUrdf(given, "robot.urdf", link, payload, findings);
    // Links alone change, of which an inertial that is replaced may be most of the file.
    if (written)
      require(written->starts_with(given.substr(0, given.find("<link"))) &&
              written->ends_with(given.substr(given.rfind('<'))) && written->find("1.2") != std::string::npos);
  }
}

void session(std::string_view bytes) {
  if (const auto read = parseSession(bytes, "input.heft", "/tmp")) (void)sessionText(*read, "/tmp");
}

void lesson(std::string_view bytes) {
  if (const auto read = parseLesson(bytes, "lesson.json")) require(!read->steps.empty() && read->answers.size() > 1);
}

/// Messages as they come over a WebSocket: each begins with 't' (text) or 'b' (binary) and ends with 0x1E.
void frames(LiveSource& source, std::string_view bytes) {
  auto& bridge = dynamic_cast<BridgeSource&>(source);
  while (!bytes.empty()) {
    const auto end = std::min(bytes.find('\x1e'), bytes.size());
    const auto frame = bytes.substr(0, end);
    if (!frame.empty()) bridge.receive({std::string(frame.substr(1)), frame[0] == 'b'});
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
}
void foxglove(std::string_view bytes) { frames(*makeFoxgloveSource("127.0.0.1", 1, {}), bytes); }
void rosbridge(std::string_view bytes) { frames(*makeRosbridgeSource("127.0.0.1", 1, {}, {}), bytes); }

/// A datagram a line.
void udp(std::string_view bytes) {
  FieldMapper mapper;
  JsonNumbers objects;
  while (!bytes.empty()) {
    const auto end = std::min(bytes.find('\n'), bytes.size());
    if (const auto* const numbers = objects.read(bytes.substr(0, end)))
      (void)mapper.map("", "", numbers->names, numbers->values);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
}

/// What a controller sends: answers to the outputs that were asked for make the recipe of the rows that follow. It
/// comes in pieces.
void rtdeStream(std::string_view bytes) {
  constexpr std::size_t kPiece = 100;
  rtde::PackageReader reader;
  rtde::Recipe recipe;
  while (!bytes.empty() && !reader.broken()) {
    const auto size = std::min(kPiece, bytes.size());
    reader.add(bytes.substr(0, size));
    bytes.remove_prefix(size);
    while (const auto received = reader.next()) {
      (void)rtde::textOf(received->content);
      if (received->type == rtde::kSetUpOutputs) {
        recipe.outputs = rtde::outputsWithout(rtde::missingIn(received->content, rtde::outputsWithout({})));
        recipe.number = received->content.empty() ? '\0' : received->content[0];
      }
      const auto row = rtde::rowOf(received->content, recipe);
      if (!row) continue;
      if (const auto stamp = rtde::stampOf(*row)) require(std::isfinite(*stamp));
      if (const auto told = rtde::configuredIn(*row)) require(std::isfinite(*told->payload.mass));
      const auto sample = rtde::sampleOf(*row);
      if (!sample) continue;
      for (const double angle : *sample->q) require(std::isfinite(angle));
      if (sample->wrench) require(sample->wrench->allFinite());
    }
  }
}

/// A page of configuration up to a zero byte, then datagrams, each after its length in two bytes.
void rdtStream(std::string_view bytes) {
  const auto zero = std::min(bytes.find('\0'), bytes.size());
  const auto told = rdt::unitsIn(bytes.substr(0, zero));
  const rdt::Units units = told ? *told : rdt::Units{1e6, 1e6};
  bytes.remove_prefix(std::min(zero + 1, bytes.size()));
  rdt::RecordReader reader;
  rdt::Counts counts;
  for (double now = 0.0; bytes.size() >= 2; now += 1e-3) {
    const auto length = static_cast<unsigned char>(bytes[0]) * 256u + static_cast<unsigned char>(bytes[1]);
    bytes.remove_prefix(2);
    for (const auto& sample : reader.read(bytes.substr(0, length), units, now, counts))
      require(std::isfinite(sample.time) && sample.wrench->allFinite());
    require(counts.late <= counts.lost);
    bytes.remove_prefix(std::min<std::size_t>(length, bytes.size()));
  }
}

void room(std::string_view bytes) {
  const auto json = parseJson(bytes, "room.json");
  if (!json) return;
  const auto read = roomFromJson(*json, "room.json", "/nonexistent");
  if (!read) return;
  require(std::isfinite(read->margin));
  for (const Obstacle& obstacle : read->obstacles) {
    if (const auto* plane = std::get_if<RoomPlane>(&obstacle.body))
      require(plane->point.allFinite() && std::abs(plane->normal.norm() - 1.0) < 1e-9);
    if (const auto* box = std::get_if<RoomBox>(&obstacle.body))
      require(box->size.allFinite() && box->size.minCoeff() > 0.0 && box->X_BO.matrix().allFinite());
  }
  require(roomFromJson(toJson(*read), "room.json", "/nonexistent").ok());
}

/// The ending tells assimp the format: it stands in the first line.
void mesh(std::string_view bytes) {
  const auto line = std::min(bytes.find('\n'), bytes.size());
  const std::string_view ending = bytes.substr(0, line);
  for (const char* known : {"stl", "obj", "ply", "dae", "off", "glb", "3mf", "x3d"}) {
    if (ending != known) continue;
    const auto read = loadMesh(asFile(bytes.substr(std::min(line + 1, bytes.size())), "." + std::string(known)));
    if (!read) return;
    for (const MeshPart& part : read->parts)
      for (const auto& triangle : part.triangles)
        for (const unsigned vertex : triangle) require(vertex < part.vertices.size());
  }
}

constexpr Parser kParsers[] = {{"recording", recording},
                               {"table", streamsOf<FileKind::table>},
                               {"json_lines", streamsOf<FileKind::jsonLines>},
                               {"ros_bag", streamsOf<FileKind::rosBag>},
                               {"mcap", streamsOf<FileKind::mcap>},
                               {"sqlite_bag", streamsOf<FileKind::sqliteBag>},
                               {"hdf5", streamsOf<FileKind::hdf5>},
                               {"matlab", streamsOf<FileKind::matlab>},
                               {"numpy", streamsOf<FileKind::numpy>},
                               {"csv", csv},
                               {"meta", meta},
                               {"messages", messages},
                               {"map", map},
                               {"shape", shape},
                               {"shape_points", shapePoints},
                               {"payload", payload},
                               {"lesson", lesson},
                               {"urdf", urdf},
                               {"urdf_copy", urdfCopy},
                               {"session", session},
                               {"foxglove", foxglove},
                               {"rosbridge", rosbridge},
                               {"udp", udp},
                               {"rtde", rtdeStream},
                               {"rdt", rdtStream},
                               {"room", room},
                               {"mesh", mesh}};

}  // namespace

std::span<const Parser> parsers() { return kParsers; }

const Parser* parserNamed(std::string_view name) {
  for (const Parser& parser : kParsers)
    if (parser.name == name) return &parser;
  return nullptr;
}

}  // namespace heft::fuzz
