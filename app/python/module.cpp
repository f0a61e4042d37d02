// The Python module heft._heft: core's functions with NumPy arrays in and out. Results come as the JSON of the command
// line, which the package heft (heft/__init__.py) turns into dataclasses, so that both hold the same numbers.
//
// Work runs without the interpreter's lock. Errors are heft.Error with the sentence that the command line prints.
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "app/cli/cli.h"
#include "app/cli/default_tool.h"
#include "app/cli/reading.h"
#include "app/version.h"
#include "core/base/json_file.h"
#include "core/compensation/compensation.h"
#include "core/diagnosis/correction/check_on_other.h"
#include "core/diagnosis/correction/corrected.h"
#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/report/report.h"
#include "core/estimation/comparison.h"
#include "core/estimation/estimate.h"
#include "core/estimation/judgement.h"
#include "core/exporters/flange.h"
#include "core/recording/csv_reader.h"
#include "core/simulation/effects/effect.h"
#include "core/simulation/simulate.h"

namespace py = pybind11;

namespace heft::python {
namespace {

using nlohmann::json;

/// As the command line writes it, in one line.
std::string textOf(const json& content) { return content.dump(-1, ' ', false, json::error_handler_t::replace); }

/// What Python sees as heft.Error and heft.Cancelled.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};
struct Cancelled : Failure {
  using Failure::Failure;
};

template <class T>
T orRaise(Result<T> result) {
  if (result) return std::move(result).value();
  if (result.error().cancelled) throw Cancelled(result.error().message);
  throw Failure(result.error().message);
}

/// Progress that calls a Python function (fraction, what); False from it, an exception in it or Ctrl+C stops the work.
class Watched {
 public:
  explicit Watched(py::object callback) : callback_(std::move(callback)) {}

  Progress progress() {
    return {stop_.get_token(), [this](double fraction, std::string_view what) { tell(fraction, what); }};
  }
  /// Raises any exception that Python raised in the meantime.
  void raise() {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void tell(double fraction, std::string_view what) {
    const py::gil_scoped_acquire lock;
    if (error_) return;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (callback_.is_none()) return;
      const py::object answer = callback_(fraction, std::string(what));
      if (answer.is(py::bool_(false))) stop_.request_stop();
    } catch (const py::error_already_set&) {
      error_ = std::current_exception();
      stop_.request_stop();
    }
  }

  py::object callback_;
  std::stop_source stop_;
  std::exception_ptr error_;
};

/// Runs `work(progress)`, which returns a Result, without the interpreter's lock.
template <class Work>
auto worked(py::object callback, const Work& work) {
  Watched watched(std::move(callback));
  auto result = [&] {
    const py::gil_scoped_release unlocked;
    return work(watched.progress());
  }();
  watched.raise();
  return orRaise(std::move(result));
}

/// A matrix or vector of `owner` as a read-only array over the same memory; None for one without rows.
template <class Matrix>
py::object arrayOf(const Matrix& matrix, const py::object& owner) {
  if (matrix.rows() == 0) return py::none();
  constexpr auto kSize = static_cast<py::ssize_t>(sizeof(double));
  std::vector<py::ssize_t> shape{matrix.rows()}, strides{kSize * matrix.rowStride()};
  if constexpr (Matrix::ColsAtCompileTime != 1) {
    shape.push_back(matrix.cols());
    strides.push_back(kSize * matrix.colStride());
  }
  py::array_t<double> out(shape, strides, matrix.data(), owner);
  out.attr("setflags")(py::arg("write") = false);
  return out;
}

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// A copy of an array of `rows` by `columns` numbers; any number of columns for 0. Raises with its name.
MatrixXd matrixFrom(const Array& array, const std::string& name, Eigen::Index rows, Eigen::Index columns) {
  const auto wanted = columns > 0 ? std::to_string(columns) : std::string("any number of");
  if (array.ndim() != 2 || array.shape(0) != rows || (columns > 0 && array.shape(1) != columns))
    throw Failure(name + " needs " + std::to_string(rows) + " rows, as many as time has values, and " + wanted +
                  " columns.");
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(array.data(), array.shape(0), array.shape(1));
}

/// The errors of the command line's functions as results.
template <class Work>
auto caught(const Progress& progress, const Work& work) -> Result<decltype(work())> {
  try {
    return work();
  } catch (const cli::Failed& failed) {
    return Error{failed.what(), progress.cancelled()};
  }
}

cli::Input completed(ReadRecording read) {
  return orRaise(caught({}, [&] { return cli::withArm(std::move(read)); }));
}

std::optional<Array> optionalArray(const py::object& object) {
  if (object.is_none()) return std::nullopt;
  return py::cast<Array>(object);
}

cli::Input fromArrays(const Array& time, const Array& wrench, const py::object& q, const py::object& dq,
                      const py::object& position, const py::object& quaternion, const std::string& meta,
                      const std::string& name) {
  Findings findings;
  Recording recording;
  recording.file = name;
  recording.meta = orRaise(parseMeta(meta, name + " (meta)", std::filesystem::current_path(), findings));
  if (time.ndim() != 1) throw Failure("time needs one dimension: the time of each row in seconds.");
  const Eigen::Index rows = time.shape(0);
  recording.time = Eigen::Map<const VectorXd>(time.data(), rows);
  recording.wrench = matrixFrom(wrench, "wrench", rows, 6);
  if (const auto array = optionalArray(q)) recording.q = matrixFrom(*array, "q", rows, 0);
  if (const auto array = optionalArray(dq)) recording.dq = matrixFrom(*array, "dq", rows, recording.q.cols());
  if (const auto array = optionalArray(position)) recording.position = matrixFrom(*array, "position", rows, 3);
  if (const auto array = optionalArray(quaternion)) recording.quaternion = matrixFrom(*array, "quaternion", rows, 4);
  for (const MatrixXd& all : {MatrixXd(recording.time), MatrixXd(recording.wrench), recording.q, recording.dq,
                              MatrixXd(recording.position), MatrixXd(recording.quaternion)})
    if (!all.allFinite()) throw Failure(name + ": some numbers are not finite. Leave out those rows.");
  ReadRecording checked = orRaise(checkRecording(std::move(recording)));
  checked.findings.insert(checked.findings.begin(), findings.begin(), findings.end());
  return completed(std::move(checked));
}

cli::Input openFile(const std::filesystem::path& file, const ImportOptions& options, py::object progress) {
  return worked(std::move(progress), [&](const Progress& watched) {
    return caught(watched, [&] { return cli::readInput(file.string(), options, options.robot, watched); });
  });
}

json parsed(const std::string& text, const std::string& name) { return orRaise(parseJson(text, name)); }

template <class Enum, std::size_t N>
Enum wordIn(const std::array<Enum, N>& values, const std::string& word, const std::string& name) {
  std::string all;
  for (const Enum value : values) {
    if (toString(value) == word) return value;
    all += (all.empty() ? "" : ", ") + std::string(toString(value));
  }
  throw Failure(name + " is one of " + all + ", not '" + word + "'.");
}

std::optional<SegmentMode> segmentsFrom(const std::optional<std::string>& word) {
  if (!word) return std::nullopt;
  if (*word == "auto") return SegmentMode::automatic;
  if (*word == "marks") return SegmentMode::marks;
  if (*word == "all") return SegmentMode::all;
  throw Failure("segments is one of auto, marks, all, not '" + *word + "'.");
}

/// Options of an estimate; `settings` holds those that are given, by their names on the command line.
EstimateOptions estimateOptions(const json& settings) {
  EstimateOptions out;
  const auto word = [&](const char* key) { return settings.at(key).get<std::string>(); };
  if (settings.contains("method")) out.method = wordIn(kAllMethods, word("method"), "method");
  if (settings.contains("parameters")) {
    constexpr std::array kSets{ParameterSet::mass, ParameterSet::massCom, ParameterSet::full};
    out.parameters = wordIn(kSets, word("parameters"), "parameters");
  }
  if (settings.contains("conventions")) {
    constexpr std::array kChoices{ConventionChoice::asStated, ConventionChoice::suggested};
    out.conventions = wordIn(kChoices, word("conventions"), "conventions");
  }
  if (settings.contains("segments")) out.segments = segmentsFrom(word("segments"));
  if (settings.contains("trim")) {
    out.trim = settings.at("trim").get<double>();
    out.keepTrim = true;
  }
  out.motion.cutoffHz = settings.value("cutoff_hz", out.motion.cutoffHz);
  out.bias = settings.value("bias", true);
  out.insideShape = settings.value("inside_shape", false);
  std::optional<Certainty> certainty;
  if (settings.contains("certainty")) {
    constexpr std::array kCertainties{Certainty::rough, Certainty::good, Certainty::exact};
    certainty = wordIn(kCertainties, word("certainty"), "certainty");
  }
  if (settings.contains("shape")) {
    const json& shape = settings.at("shape");
    out.shape = orRaise(shape.is_string() ? parseShape(shape.get<std::string>())
                                          : shapeFromJson(shape, "shape", std::filesystem::current_path()));
    if (certainty) out.shape->certainty = *certainty;
  }
  if (settings.contains("mass")) {
    const json& mass = settings.at("mass");
    out.stated.push_back(orRaise(parseScaleMass(mass.is_string() ? mass.get<std::string>() : mass.dump())));
  }
  if (settings.contains("cad")) {
    json cad = settings.at("cad");
    if (certainty && cad.is_object()) cad["certainty"] = toString(*certainty);
    out.stated.push_back(orRaise(statedPayloadFromJson(cad, "cad")));
  }
  if (settings.contains("known")) out.known = orRaise(partialPayloadFromJson(settings.at("known"), "known"));
  return out;
}

EstimateReport runEstimate(const cli::Input& input, const std::string& settings, py::object progress) {
  const EstimateOptions options = estimateOptions(parsed(settings, "settings"));
  EstimateReport report = worked(std::move(progress), [&](const Progress& watched) {
    return estimate(input.recording, input.model(), options, watched);
  });
  addReadingFindings(input.findings, report);
  return report;
}

DiagnosisReport runDiagnosis(const cli::Input& input, const std::optional<std::string>& segments,
                             const std::vector<std::string>& without, int surrogates, unsigned seed,
                             const cli::Input* check, py::object progress) {
  DiagnoseOptions options;
  options.segments = segmentsFrom(segments);
  options.hidden = without;
  options.surrogates = surrogates;
  options.seed = seed;
  return worked(std::move(progress), [&](const Progress& watched) -> Result<DiagnosisReport> {
    auto report = diagnose(input.recording, input.model(), options, watched);
    if (!report) return report;
    report->findings.insert(report->findings.begin(), input.findings.begin(), input.findings.end());
    if (check != nullptr) {
      auto held = checkOn(*report, check->recording, check->model());
      if (!held) return held.error();
      report->check = std::move(held).value();
    }
    return report;
  });
}

struct SimulatedRun {
  cli::Input input;
  std::string truth;
};

SimulatedRun runSimulation(const std::string& motion, const std::optional<std::string>& payload, double duration,
                           double rateHz, double speed, std::uint64_t seed, const std::vector<std::string>& effects,
                           const std::string& given, py::object progress) {
  const json settings = parsed(given, "settings");
  SimulateOptions options;
  constexpr std::array kMotions{MotionKind::excitation, MotionKind::pickAndPlace, MotionKind::free};
  options.motion = wordIn(kMotions, motion, "motion");
  options.duration = duration;
  options.rateHz = rateHz;
  options.speed = speed;
  options.seed = seed;
  options.sensor.forceNoise = settings.value("force_noise", options.sensor.forceNoise);
  options.sensor.torqueNoise = settings.value("torque_noise", options.sensor.torqueNoise);
  options.positionNoise = settings.value("joint_noise", options.positionNoise);
  options.positionStep = settings.value("joint_step", options.positionStep);
  for (const auto& effect : effects) options.effects.push_back(orRaise(parseEffect(effect)));
  const Payload carried =
      payload ? orRaise(payloadFromJson(parsed(*payload, "payload"), "payload")) : cli::defaultTool();
  Simulated simulated = worked(std::move(progress), [&](const Progress& watched) {
    return simulate(RobotModel::panda(), carried, options, watched);
  });
  simulated.recording.file = "simulated";
  return {completed({std::move(simulated.recording), {}}), textOf(toJson(simulated.truth))};
}

Compensated runCompensation(const cli::Input& input, const std::string& result,
                            const std::optional<std::string>& diagnosis, py::object progress) {
  const CompensateOptions options = orRaise(compensateOptionsFromJson(parsed(result, "result"), "result"));
  return worked(std::move(progress), [&](const Progress& watched) -> Result<Compensated> {
    if (!diagnosis) return compensate(input.recording, input.model(), options, watched);
    auto found = parseJson(*diagnosis, "diagnosis");
    if (!found) return found.error();
    auto corrected = correctedByAll(input.recording, input.model(), *found, "diagnosis");
    if (!corrected) return corrected.error();
    return compensate(*corrected, input.model(), options, watched);
  });
}

py::tuple runExport(const std::string& result, const std::string& format, const std::string& name, bool force,
                    const std::vector<std::string>& add) {
  const ExportFormat* found = findExportFormat(format);
  if (found == nullptr) {
    std::string all;
    for (const auto& known : exportFormats()) all += (all.empty() ? "" : ", ") + std::string(known.id);
    throw Failure("format is one of " + all + ", not '" + format + "'.");
  }
  FlangeOptions options;
  options.name = name;
  options.force = force;
  options.program = cli::programVersion();
  for (const auto& text : add) {
    options.add.push_back(orRaise(payloadFromJson(parsed(text, "add"), "add")));
    options.addNames.emplace_back("added");
  }
  FlangePayload payload = orRaise(toFlange(parsed(result, "result"), "result", options));
  const std::string text = orRaise(exportPayload(*found, payload.input, payload.findings));
  return py::make_tuple(text, textOf(cli::toJson(payload.findings)));
}

void defineRecording(py::module_& module) {
  py::class_<cli::Input>(module, "Recording")
      .def_property_readonly("file", [](const cli::Input& self) { return self.recording.file; })
      .def_property_readonly("samples", [](const cli::Input& self) { return self.recording.rows(); })
      .def_property_readonly("duration_s", [](const cli::Input& self) { return self.recording.duration(); })
      .def_property_readonly("rate_hz", [](const cli::Input& self) { return self.recording.rateHz(); })
      .def_property_readonly("findings_json", [](const cli::Input& self) { return textOf(cli::toJson(self.findings)); })
      .def("array",
           [](const py::object& self, const std::string& name) -> py::object {
             const Recording& r = self.cast<const cli::Input&>().recording;
             if (name == "time") return arrayOf(r.time, self);
             if (name == "q") return arrayOf(r.q, self);
             if (name == "dq") return arrayOf(r.dq, self);
             if (name == "position") return arrayOf(r.position, self);
             if (name == "quaternion") return arrayOf(r.quaternion, self);
             if (name == "twist") return arrayOf(r.twist, self);
             return arrayOf(r.wrench, self);
           })
      .def("save", [](const cli::Input& self, const std::filesystem::path& csv) {
        orRaise(writeRecording(self.recording, csv));
      });
  py::class_<ImportOptions>(module, "ImportOptions")
      .def(py::init())
      .def_readwrite("meta", &ImportOptions::metaFile)
      .def_readwrite("map", &ImportOptions::mapFile)
      .def_readwrite("join", &ImportOptions::join)
      .def_readwrite("use", &ImportOptions::use)
      .def_readwrite("rate_hz", &ImportOptions::rateHz)
      .def_readwrite("robot", &ImportOptions::robot);
  module.def("open", &openFile);
  module.def("from_arrays", &fromArrays);
}

void defineResults(py::module_& module) {
  py::class_<EstimateReport>(module, "Estimated")
      .def("json", [](const EstimateReport& self) { return textOf(toJson(self)); })
      .def("text", [](const EstimateReport& self) { return toText(self); })
      .def("array", [](const py::object& self, const std::string& name) {
        const WrenchSeries& series = self.cast<const EstimateReport&>().series;
        if (name == "time") return arrayOf(series.time, self);
        return arrayOf(name == "measured" ? series.measured : series.simulated, self);
      });
  py::class_<DiagnosisReport>(module, "Diagnosed")
      .def("json", [](const DiagnosisReport& self) { return textOf(toJson(self)); })
      .def("text", [](const DiagnosisReport& self) { return toText(self); })
      .def("before_json", [](const DiagnosisReport& self) { return textOf(toJson(self.before)); })
      .def("after_json", [](const DiagnosisReport& self) { return textOf(toJson(self.after)); })
      .def("array", [](const py::object& self, const std::string& name) -> py::object {
        const DiagnosisSeries& series = self.cast<const DiagnosisReport&>().series;
        if (name == "time") return arrayOf(series.time, self);
        const auto& channels = name == "measured" ? series.measured : name == "before" ? series.before : series.after;
        const py::object array = arrayOf(channels, self);
        return array.is_none() ? array : array.attr("T");
      });
  py::class_<SimulatedRun>(module, "Simulated")
      .def_readonly("recording", &SimulatedRun::input)
      .def_readonly("truth_json", &SimulatedRun::truth);
  py::class_<Compensated>(module, "Compensated")
      .def("json",
           [](const Compensated& self, const cli::Input& input) {
             json result = toJson(self, input.recording);
             result["findings"] = cli::toJson(self.findings);
             return textOf(result);
           })
      .def("phases",
           [](const Compensated& self) {
             std::vector<std::string> names;
             for (const Phase phase : self.phase) names.emplace_back(toString(phase));
             return names;
           })
      .def("array", [](const py::object& self, const std::string& name) {
        const auto& compensated = self.cast<const Compensated&>();
        return name == "time" ? arrayOf(compensated.time, self) : arrayOf(compensated.wrench, self);
      });
}

}  // namespace

PYBIND11_MODULE(_heft, module) {
  const py::exception<Failure>& error = py::register_exception<Failure>(module, "Error");
  py::register_exception<Cancelled>(module, "Cancelled", error.ptr());
  defineRecording(module);
  defineResults(module);
  module.def("estimate", &runEstimate);
  module.def("diagnose", &runDiagnosis, py::arg("recording"), py::arg("segments"), py::arg("without"),
             py::arg("surrogates"), py::arg("seed"), py::arg("check").none(true), py::arg("progress"));
  module.def("simulate", &runSimulation);
  module.def("compensate", &runCompensation);
  module.def("export", &runExport);
  module.def("export_formats", [] {
    std::vector<std::pair<std::string, std::string>> all;
    for (const auto& format : exportFormats()) all.emplace_back(format.id, format.title);
    return all;
  });
  module.attr("version") = version();
}

}  // namespace heft::python
