// Writes the Panda's URDF and meshes: make_panda FOLDER (resources/robots/panda). Run it after a change of its shapes
// and commit what it wrote; a test compares.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "resources/robots/panda/generator/panda_files.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: make_panda FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::error_code problem;
  std::filesystem::create_directories(folder / "meshes", problem);
  for (const auto& [name, content] : heft::panda_maker::pandaFiles()) {
    std::ofstream file(folder / name, std::ios::binary);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    if (!file) {
      fmt::print(stderr, "make_panda: {} cannot be written\n", (folder / name).string());
      return 1;
    }
    fmt::print("{:>8} bytes  {}\n", content.size(), name);
  }
  return 0;
}
