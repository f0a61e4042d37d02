// Broken files are told of in German where the program speaks German: whole sentences, with file, line and column as
// they are in English, and with a decimal comma.
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "core/base/say.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/import/import.h"
#include "core/mesh/mesh.h"
#include "core/payload/shape.h"
#include "core/robot/robot_model.h"
#include "core/workspace/session.h"

namespace heft {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string unescaped(std::string text) {
  for (const auto& [from, to] :
       {std::pair{"&quot;", "\""}, {"&apos;", "'"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}})
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + std::string(to).size()))
      text.replace(at, std::string(from).size(), to);
  return text;
}

/// English to German, of the heading that core's texts stand under.
const std::map<std::string, std::string>& dictionary() {
  static const auto kAll = [] {
    std::ifstream file(HEFT_SOURCE_DIR "/resources/translations/heft_de.ts");
    std::stringstream all;
    all << file.rdbuf();
    std::string text = all.str();
    const auto from = text.find("<name>heft</name>");
    text = text.substr(from, text.find("</context>", from) - from);
    static const std::regex kPair(R"(<source>([^<]*)</source>\s*<translation>([^<]*)</translation>)");
    std::map<std::string, std::string> out;
    for (std::sregex_iterator it(text.begin(), text.end(), kPair), end; it != end; ++it)
      out[unescaped((*it)[1].str())] = unescaped((*it)[2].str());
    return out;
  }();
  return kAll;
}

class German : public testing::Test {
 protected:
  German() : folder(fs::temp_directory_path() / ("heft_german_" + std::to_string(::getpid()))) {
    fs::create_directories(folder);
    setTranslator(
        [](const char* pattern) {
          const auto it = dictionary().find(pattern);
          return it == dictionary().end() ? std::string() : it->second;
        },
        ',');
  }
  ~German() override {
    setTranslator({});
    fs::remove_all(folder);
  }
  fs::path write(const char* name, const std::string& content) {
    std::ofstream(folder / name, std::ios::binary) << content;
    return folder / name;
  }
  /// The sentence about a recording that cannot be read.
  std::string aboutRecording(const std::string& csv, const std::string& meta = {}) {
    fs::remove(folder / "rec.meta.json");
    if (!meta.empty()) write("rec.meta.json", meta);
    return sentence(openRecording(write("rec.csv", csv)));
  }
  template <class T>
  static std::string sentence(const Result<T>& result) {
    EXPECT_FALSE(result.ok());
    if (result.ok()) return {};
    const std::string& text = result.error().message;
    static const std::regex kEnglish(R"(\b(the|this|is|are|has|have|must|cannot|with|from|and|not|there|in the)\b)",
                                     std::regex::icase);
    // What stands in quotes or in brackets is the file's or another library's.
    static const std::regex kQuoted(R"(„[^“]*“|"[^"]*"|\([^)]*\))");
    const std::string plain = std::regex_replace(text, kQuoted, "");
    EXPECT_FALSE(std::regex_search(plain, kEnglish)) << text;
    return text;
  }

  fs::path folder;
};

constexpr const char* kHeader = "time,q1,q2,q3,q4,q5,q6,q7,fx,fy,fz,tx,ty,tz\n";

TEST_F(German, Recordings) {
  EXPECT_THAT(sentence(openRecording(folder / "none.csv")), HasSubstr("none.csv"));
  EXPECT_THAT(aboutRecording(""), HasSubstr("die Datei ist leer."));
  EXPECT_THAT(aboutRecording(kHeader), HasSubstr("es gibt eine Kopfzeile, aber keine Daten darunter."));
  EXPECT_THAT(aboutRecording(std::string(kHeader) + "0,1,hallo,0,0,0,0,0,1,2,3,4,5,6\n"),
              HasSubstr("rec.csv:2:3: „hallo“ in Spalte q2 ist keine Zahl."));
  EXPECT_THAT(aboutRecording(std::string(kHeader) + "0,1\n"),
              HasSubstr("rec.csv:2: diese Zeile hat 2 Zellen, aber die Kopfzeile nennt 14 Spalten."));
  EXPECT_THAT(aboutRecording("time,fx,fy,fz,tx,ty,tz\n0,1,2,3,4,5,6\n"), HasSubstr("keine Bewegung"));
  EXPECT_THAT(sentence(openRecording(folder)), HasSubstr("Ordner"));
  EXPECT_THAT(aboutRecording(std::string(kHeader) + "1.5,0,0,0,0,0,0,0,1,2,3,4,5,6\n0.5,0,0,0,0,0,0,0,1,2,3,4,5,6\n"),
              HasSubstr("die Zeit fällt von 1,5 s auf 0,5 s."));
}

TEST_F(German, MetaFiles) {
  const std::string row = std::string(kHeader) + "0,0,0,0,0,0,0,0,1,2,3,4,5,6\n0.1,0,0,0,0,0,0,0,1,2,3,4,5,6\n";
  EXPECT_THAT(aboutRecording(row, "{\"robot\": "), HasSubstr("kein gültiges JSON"));
  EXPECT_THAT(aboutRecording(row, "[]"), HasSubstr("eine Aufbaudatei muss ein JSON-Objekt {...} sein"));
  EXPECT_THAT(aboutRecording(row, "{\"kind\": \"dance\"}"), HasSubstr("kind: muss \"motion\" oder \"poses\" sein"));
  EXPECT_THAT(
      aboutRecording(row, "{\"robot\": \"panda\", \"sensor\": {\"mount\": {\"xyz_m\": [0, 0, 107.5]}}}"),
      HasSubstr(
          "der Sensor kann nicht 107,5 m von seinem Glied entfernt sitzen. Geben Sie Meter an, nicht Millimeter."));
  EXPECT_THAT(aboutRecording(row, "{\"gravity_m_s2\": [0, 0, -981]}"), HasSubstr("auf keinem Planeten"));
}

TEST_F(German, RobotsMeshesShapesAndSessions) {
  Findings findings;
  EXPECT_THAT(sentence(RobotModel::fromUrdfFile(write("a.urdf", "<robot name=\"a\"><link>"), findings)),
              HasSubstr("nie geschlossen"));
  EXPECT_THAT(sentence(RobotModel::fromUrdfFile(write("b.urdf", "PK\x03"), findings)), HasSubstr("b.urdf"));
  EXPECT_THAT(sentence(loadMesh(folder / "none.stl")), HasSubstr("Diese Netz-Datei gibt es nicht."));
  EXPECT_THAT(sentence(loadMesh(write("a.stl", ""))),
              HasSubstr("Die Netz-Datei ist leer oder lässt sich nicht lesen."));
  EXPECT_THAT(sentence(loadMesh(write("a.drawing", "lines"))),
              HasSubstr("Netze der Art „.drawing“ sind nicht bekannt."));
  EXPECT_THAT(sentence(readShapeFile(write("s.json", R"({"bodies": [{"kind": "box", "dims_m": [0.1, 0.1]}]})"))),
              HasSubstr("Quader braucht 3 Maße in Metern (x, y, z), angegeben sind aber 2."));
  EXPECT_THAT(sentence(readSession(write("a.heft", "{\"schema\": \"another/1\"}"))),
              HasSubstr("ist keine Sitzung von Heft Studio"));
  EXPECT_THAT(sentence(readSession(write("b.heft", "{\"schema\": \"heft.session/99999\"}"))),
              HasSubstr("Aktualisieren Sie Heft"));
  EXPECT_THAT(sentence(readSession(folder / "none.heft")), HasSubstr("Diese Datei gibt es nicht."));
}

TEST_F(German, CausesOfMisfit) {
  for (const auto* list : {&diagnosis::catalogue(), &diagnosis::seenDirectly()})
    for (const auto& cause : *list) {
      const diagnosis::CauseInfo& info = cause->info();
      if (info.id == diagnosis::kRandomWalk) continue;  // Nothing is said of it
      for (const char* text : {info.title, info.check, info.decides, info.looks})
        EXPECT_TRUE(dictionary().contains(text)) << info.id << ": " << text;
    }
}

}  // namespace
}  // namespace heft
