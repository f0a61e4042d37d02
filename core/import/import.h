#pragma once
// One way into every kind of recording: CSV in contract form, tables of PlotJuggler, rostopic and libfranka, JSON
// lines, ROS 1 and ROS 2 bags, MCAP, HDF5, MATLAB, NumPy. The kind is told by the content, never by the name.
//
// Streams of different rates are joined on the times of the slower one of motion and wrench; the faster is averaged
// over its steps. Streams of one file share a clock (message headers' where they are sound, else the recorder's).
// Files without a common clock are shifted against each other until the force follows the motion; the shift is a
// finding, and where the data do not tell it, opening fails and says how to state it.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/findings.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/import/mapping.h"
#include "core/import/streams.h"
#include "core/recording/csv_reader.h"

namespace heft {

struct ImportOptions {
  std::filesystem::path metaFile;           ///< Empty: NAME.meta.json beside the recording if it exists.
  std::filesystem::path mapFile;            ///< Topics and columns, see readMapFile. Empty: mapFileOf() if it exists.
  std::optional<MappingWishes> wishes;      ///< Instead of any map file.
  std::vector<std::filesystem::path> join;  ///< Further files, for instance of the wrench.
  std::vector<std::string> use;             ///< "wrench=/ft/raw", "q1=/arm:position[j1]"; stronger than the map file.
  double rateHz = 0.0;  ///< Of files without a clock; above 0 it holds before any time in the file, but for
                        ///< joined files that have a clock.
  std::string robot;    ///< "panda" or a URDF, instead of the setup file's; empty: the setup file's.

  /// True if nothing says where columns come from.
  bool empty() const { return mapFile.empty() && !wishes && join.empty() && use.empty() && rateHz <= 0.0; }
};

/// What a recording holds and what Heft would take from it: for a dialog of topics and columns.
struct RecordingContents {
  FileKind kind = FileKind::contractCsv;
  std::vector<Stream> streams;              ///< Of the recording and of joined files; their fields are names only.
  std::vector<ColumnCandidate> candidates;  ///< Best first; `why` is for the user to read.
  std::vector<ColumnSource> chosen;         ///< Empty if a part is missing; `missing` says which.
  std::vector<ColumnSource> proposed;       ///< Then: what would be taken of the parts that are there.
  std::string missing;                      ///< The sentence with which openRecording would fail.
  std::vector<std::string> timeCandidates;  ///< What may be chosen as the time ("use": {"time": ...}).
  MappingWishes wishes;                     ///< What was said, by a map file or the options.
  Findings findings;
};

/// Lists topics, columns and the guess, without reading all of the file where that can be avoided.
Result<RecordingContents> inspectRecording(const std::filesystem::path& path, const ImportOptions& options = {},
                                           const Progress& progress = {});

/// Reads any recording. The findings say what was read, joined, shifted, repaired and left out.
Result<ReadRecording> openRecording(const std::filesystem::path& path, const ImportOptions& options = {},
                                    const Progress& progress = {});

/// True for names that a file dialog should offer: .csv .bag .mcap .db3 .zstd .h5 .hdf5 .mat .npy
/// .npz .jsonl .json .txt .log
bool looksLikeRecording(const std::filesystem::path& name);

}  // namespace heft
