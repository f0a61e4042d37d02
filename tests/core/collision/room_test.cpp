#include "core/collision/room.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace heft {
namespace {

using nlohmann::json;
using testing::HasSubstr;

json tableAndRack() {
  return {
      {"schema", "heft.room/1"},
      {"margin_m", 0.03},
      {"obstacles",
       {{{"name", "table"}, {"plane", {{"point_m", {0, 0, 0.1}}, {"normal", {0, 0, 2}}}}},
        {{"name", "rack"}, {"box", {{"size_m", {0.2, 0.3, 1}}, {"xyz_m", {0.7, 0, 0.5}}, {"rpy_rad", {0, 0, 0.4}}}}}}}};
}

std::string errorOf(const json& content) {
  const auto room = roomFromJson(content, "room.json", {});
  return room ? std::string() : room.error().message;
}

TEST(Room, IsReadAndWrittenTheSame) {
  const auto room = roomFromJson(tableAndRack(), "room.json", {});
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_EQ(room->margin, 0.03);
  EXPECT_EQ(std::get<RoomPlane>(room->obstacles[0].body).normal, Vector3d::UnitZ());
  const auto same = roomFromJson(toJson(*room), "again", {});
  ASSERT_TRUE(same);
  EXPECT_EQ(toJson(*same)["obstacles"][0], toJson(*room)["obstacles"][0]);
  const auto &rack = std::get<RoomBox>(room->obstacles[1].body), &back = std::get<RoomBox>(same->obstacles[1].body);
  EXPECT_EQ(rack.size, back.size);
  EXPECT_TRUE(rack.X_BO.isApprox(back.X_BO, 1e-12));
}

TEST(Room, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(errorOf(json::array()), HasSubstr("heft.room/1"));
  json bad = tableAndRack();
  bad["obstacles"][0]["plane"]["normal"] = {0, 0, 0};
  EXPECT_THAT(errorOf(bad), HasSubstr("obstacle 1"));
  bad = tableAndRack();
  bad["obstacles"][1]["box"]["size_m"] = {0.1, "wide", 1};
  EXPECT_THAT(errorOf(bad), HasSubstr("size_m must be three numbers"));
  bad["obstacles"][1]["box"]["size_m"] = {0.1, -1, 1};
  EXPECT_THAT(errorOf(bad), HasSubstr("above zero"));
  bad = tableAndRack();
  bad["obstacles"][1].erase("name");
  EXPECT_THAT(errorOf(bad), HasSubstr("\"name\""));
  bad["obstacles"][1]["name"] = "table";
  EXPECT_THAT(errorOf(bad), HasSubstr("called table"));
  bad["obstacles"][1] = {{"name", "ball"}, {"ball", {{"radius", 1}}}};
  EXPECT_THAT(errorOf(bad), HasSubstr("one of"));
  bad["obstacles"][1] = {{"name", "cell"}, {"mesh", {{"file", "no_such_file.stl"}}}};
  EXPECT_THAT(errorOf(bad), HasSubstr("no_such_file.stl"));
  bad = tableAndRack();
  bad["margin_m"] = -1;
  EXPECT_THAT(errorOf(bad), HasSubstr("margin_m"));
}

}  // namespace
}  // namespace heft
