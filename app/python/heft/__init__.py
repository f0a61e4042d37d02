"""Payload inertial parameters of robot tools, from recordings of motion and wrist wrench.

    import heft
    recording = heft.open("rec.csv")
    result = heft.estimate(recording)
    print(result.payload.mass_kg, result.interval95.mass_kg, result.trust)
    result.plot()

Units are SI. Wrenches are what the sensor exerts on the payload, in the axes S of the sensor, about its origin; forces
come before torques. Arrays of a recording are read-only views of its memory. Numbers are those of the command line
`heft`, and so are the sentences of errors (heft.Error).

Long work takes `progress`, a function of the done fraction (0 to 1) and of what is being done; where it returns False
the work stops with heft.Cancelled. Ctrl+C stops it, too. Other threads run meanwhile.
"""
from __future__ import annotations

import json as _json
import os as _os
from typing import Any, Callable, Iterable, Mapping, Optional, Sequence, Union

import numpy as _np

from . import _heft
from ._heft import Cancelled, Error
from .results import Cause, Compensation, Diagnosis, Estimate, Exported, Finding, Interval95, Payload, Segment

__version__: str = _heft.version
__all__ = [
    "Cancelled", "Cause", "Compensation", "Diagnosis", "Error", "Estimate", "Exported", "Finding", "Interval95",
    "Payload", "Recording", "Segment", "compensate", "diagnose", "estimate", "export", "export_formats", "open",
    "simulate",
]

Progress = Optional[Callable[[float, str], Any]]
PathLike = Union[str, "_os.PathLike[str]"]


class Recording:
    """Samples of motion and wrench on one clock, as heft.open(), heft.simulate() or from_arrays() make them.

    N rows; an array that the recording lacks is None. All are read-only views, F_PSo_S and R_BS in the notation of
    Drake (B: the robot's base, S: the sensor, P: the payload).

    time        (N,)    [s], rising
    q, dq       (N, J)  joint angles [rad] and velocities [rad/s] of the arm's J joints
    position    (N, 3)  p_BSo_B, the sensor's origin in base axes [m]
    quaternion  (N, 4)  R_BS as x, y, z, w
    wrench      (N, 6)  force [N] and torque [N m] of the sensor on the payload, sensor axes
    """

    def __init__(self, core: Any, truth: Optional[dict] = None):
        self._core = core
        #: What a simulated recording hides: payload, bias, marks, effects. None for any other.
        self.truth = truth

    @staticmethod
    def from_arrays(time, wrench, *, q=None, dq=None, position=None, quaternion=None,
                    meta: Optional[Mapping[str, Any]] = None, name: str = "arrays") -> "Recording":
        """A recording from arrays of N rows, shapes and units as above, with the same checks as a file's.

        `meta`: what a setup file would say, such as {"robot": "panda", "sensor": {"mount": {...}}}; its conventions are
        taken out of the numbers. Raises heft.Error that says what is wrong with which row.
        """
        text = _json.dumps({} if meta is None else dict(meta))
        return Recording(_heft.from_arrays(time, wrench, q, dq, position, quaternion, text, name))

    @property
    def time(self) -> _np.ndarray:
        return self._core.array("time")

    @property
    def q(self) -> Optional[_np.ndarray]:
        return self._core.array("q")

    @property
    def dq(self) -> Optional[_np.ndarray]:
        return self._core.array("dq")

    @property
    def position(self) -> Optional[_np.ndarray]:
        return self._core.array("position")

    @property
    def quaternion(self) -> Optional[_np.ndarray]:
        return self._core.array("quaternion")

    @property
    def wrench(self) -> _np.ndarray:
        return self._core.array("wrench")

    @property
    def file(self) -> str:
        return self._core.file

    @property
    def duration_s(self) -> float:
        return self._core.duration_s

    @property
    def rate_hz(self) -> float:
        return self._core.rate_hz

    @property
    def findings(self) -> list[Finding]:
        """What was read, joined, repaired and left out."""
        return Finding.list_from(_json.loads(self._core.findings_json))

    def __len__(self) -> int:
        return self._core.samples

    def __repr__(self) -> str:
        return f"<heft.Recording {self.file!r}: {len(self)} rows, {self.duration_s:.1f} s at {self.rate_hz:.0f} Hz>"

    def save(self, csv: PathLike) -> None:
        """Writes NAME.csv and NAME.meta.json in the plain form, as `heft convert` does."""
        self._core.save(csv)


def _recording(source: Union[Recording, PathLike]) -> Recording:
    return source if isinstance(source, Recording) else open(source)


def open(file: PathLike, *, meta: Optional[PathLike] = None, map: Optional[PathLike] = None,
         join: Sequence[PathLike] = (), use: Sequence[str] = (), rate_hz: float = 0.0, robot: str = "",
         progress: Progress = None) -> Recording:
    """Reads any recording that `heft` reads: CSV, ROS bags, MCAP, HDF5, MATLAB, NumPy.

    The arguments are those of the command line: --meta, --map, --join, --use ("wrench=/ft/raw"), --rate [Hz] and
    --robot ("panda" or a URDF). Raises heft.Error with file, line and column.
    """
    options = _heft.ImportOptions()
    if meta is not None:
        options.meta = meta
    if map is not None:
        options.map = map
    options.join = list(join)
    options.use = list(use)
    options.rate_hz = rate_hz
    options.robot = robot
    return Recording(_heft.open(file, options, progress))


def estimate(recording: Union[Recording, PathLike], *, method: str = "map", parameters: str = "full",
             segments: Optional[str] = None, conventions: str = "as-stated", trim: Optional[float] = None,
             cutoff_hz: Optional[float] = None, bias: bool = True, shape: Union[str, Mapping, None] = None,
             inside_shape: bool = False, mass: Union[float, str, None] = None, cad: Optional[Mapping] = None,
             certainty: Optional[str] = None, known: Optional[Mapping] = None,
             progress: Progress = None) -> Estimate:
    """Mass, centre of mass and inertia of what the sensor carries, with 95 % intervals.

    Arguments as on the command line (`heft estimate --help`): `shape` is "box:0.06,0.06,0.16" or the content of a shape
    file; `mass` what a scale shows [kg], 0.812 or "0.812+-0.004"; `cad` and `known` payloads as dictionaries (mass_kg,
    com_m, inertia_com_kgm2). With trust "none" the numbers mean nothing: findings and text say what to do.
    """
    settings = {"method": method, "parameters": parameters, "conventions": conventions, "bias": bias,
                "inside_shape": inside_shape}
    optional = {"segments": segments, "trim": trim, "cutoff_hz": cutoff_hz, "shape": shape, "mass": mass, "cad": cad,
                "certainty": certainty, "known": known}
    settings.update({name: value for name, value in optional.items() if value is not None})
    return Estimate.from_core(_heft.estimate(_recording(recording)._core, _json.dumps(settings), progress))


def diagnose(recording: Union[Recording, PathLike], *, segments: Optional[str] = None, without: Sequence[str] = (),
             surrogates: int = 200, seed: int = 1, check: Union[Recording, PathLike, None] = None,
             progress: Progress = None) -> Diagnosis:
    """What the simulation of this recording gets wrong: named causes, their sizes, evidence and gain.

    `without`: causes that are not looked for; `check`: another recording of the same rig on which the causes are tried;
    `surrogates`: simulated clean recordings that set the threshold (0: a fixed one).
    """
    other = None if check is None else _recording(check)._core
    return Diagnosis.from_core(
        _heft.diagnose(_recording(recording)._core, segments, list(without), surrogates, seed, other, progress))


def simulate(motion: str = "free", *, payload: Optional[Mapping] = None, duration_s: float = 20.0,
             rate_hz: float = 1000.0, speed: float = 1.0, seed: int = 1, effects: Iterable[str] = (),
             force_noise: Optional[float] = None, torque_noise: Optional[float] = None,
             joint_noise: Optional[float] = None, joint_step: Optional[float] = None,
             progress: Progress = None) -> Recording:
    """A recording of a simulated Panda, with its truth in `Recording.truth`; the same seed gives the same numbers.

    motion: "excitation", "pick-and-place" or "free". payload: in sensor axes; a tool of 0.8 kg if absent. effects: faults
    to hide, such as "cable_pull=3" (`heft simulate --list-effects`). Noise: standard deviations [N], [N m], [rad].
    """
    optional = {"force_noise": force_noise, "torque_noise": torque_noise, "joint_noise": joint_noise,
                "joint_step": joint_step}
    settings = {name: value for name, value in optional.items() if value is not None}
    made = _heft.simulate(motion, None if payload is None else _json.dumps(dict(payload)), duration_s, rate_hz, speed,
                          seed, list(effects), _json.dumps(settings), progress)
    return Recording(made.recording, _json.loads(made.truth_json))


def compensate(recording: Union[Recording, PathLike], result: Union[Estimate, Payload, Mapping], *,
               diagnosis: Optional[Diagnosis] = None, progress: Progress = None) -> Compensation:
    """The wrench without the payload's share and bias, and the phases free, approach, contact and ignore.

    `diagnosis`: its causes are taken out first.
    """
    source = _recording(recording)
    found = None if diagnosis is None else _json.dumps(diagnosis.to_dict())
    done = _heft.compensate(source._core, _json.dumps(_as_dict(result)), found, progress)
    return Compensation.from_core(done, source._core)


def export(result: Union[Estimate, Payload, Mapping], format: str, file: Optional[PathLike] = None, *,
           name: str = "tool", add: Sequence[Mapping] = (), force: bool = False) -> Exported:
    """The payload in flange axes as a controller or simulator reads it; written to `file` if one is given.

    `format`: see export_formats(). `add`: payloads in the flange frame of what else is mounted. An existing file is not
    replaced, and an estimate without trust not written, unless `force`.
    """
    text, findings = _heft.export(_json.dumps(_as_dict(result)), format, name, force,
                                  [_json.dumps(_as_dict(one)) for one in add])
    if file is not None:
        with _open_file(file, "w" if force else "x") as out:
            out.write(text)
    return Exported(text, Finding.list_from(_json.loads(findings)))


def export_formats() -> dict[str, str]:
    """Names of the formats that export() writes, and what each is."""
    return dict(_heft.export_formats())


def _open_file(file: PathLike, mode: str):
    import io
    try:
        return io.open(file, mode, encoding="utf-8", newline="\n")
    except FileExistsError:
        raise Error(f"{_os.fspath(file)} exists; give force=True to replace it.") from None


def _as_dict(result: Union[Estimate, Payload, Mapping]) -> dict:
    return result.to_dict() if isinstance(result, (Estimate, Payload)) else dict(result)
