"""What Heft finds, as dataclasses with the names of its JSON files."""
from __future__ import annotations

import dataclasses
import json
from typing import Any, Mapping, Optional

import numpy as np


@dataclasses.dataclass(frozen=True)
class Finding:
    """What the user should know: `severity` is "info", "warning" or "error"; `code` never changes, texts may."""

    severity: str
    code: str
    text: str
    remedy: str = ""
    where: Any = None

    @staticmethod
    def list_from(findings: list) -> list["Finding"]:
        names = {field.name for field in dataclasses.fields(Finding)}
        return [Finding(**{key: value for key, value in found.items() if key in names}) for found in findings]


@dataclasses.dataclass(frozen=True)
class Payload:
    """Mass [kg], centre of mass (3,) [m] and inertia about it (3, 3) [kg m2], in sensor axes from its origin."""

    mass_kg: float
    com_m: np.ndarray
    inertia_com_kgm2: np.ndarray

    @staticmethod
    def from_dict(payload: Mapping) -> "Payload":
        return Payload(payload["mass_kg"], np.array(payload["com_m"]), np.array(payload["inertia_com_kgm2"]))

    def to_dict(self) -> dict:
        return {"mass_kg": float(self.mass_kg), "com_m": np.asarray(self.com_m).tolist(),
                "inertia_com_kgm2": np.asarray(self.inertia_com_kgm2).tolist()}


@dataclasses.dataclass(frozen=True)
class Interval95:
    """95 % intervals: lower and upper bound in the last axis, (2,), (3, 2) and (3, 3, 2)."""

    mass_kg: np.ndarray
    com_m: np.ndarray
    inertia_com_kgm2: np.ndarray

    @staticmethod
    def from_dict(interval: Mapping) -> "Interval95":
        return Interval95(*(np.array(interval[key]) for key in ("mass_kg", "com_m", "inertia_com_kgm2")))


@dataclasses.dataclass(frozen=True)
class Segment:
    """A segment [from_s, to_s] labelled "free", "contact" or "ignore", with the reason in words."""

    from_s: float
    to_s: float
    label: str
    kind: str
    reason: str
    confidence: float


class _FromJson:
    """Keeps the JSON that the dataclass was made from."""

    _content: dict

    def to_dict(self) -> dict:
        """The content of the file that the command line's --json writes."""
        return self._content


@dataclasses.dataclass(frozen=True)
class Estimate(_FromJson):
    """A heft.estimate/1. `time` (K,), `measured` and `simulated` (K, 6) are the wrenches that were compared."""

    payload: Payload
    std: Payload
    interval95: Interval95
    trust: str
    method: str
    parameters: str
    bias: dict
    physically_consistent: bool
    identifiability: dict
    conventions: dict
    evidence: dict
    residual: dict
    recording: dict
    segments: list[Segment]
    sensor_mount: dict
    termination: dict
    timing_s: dict
    findings: list[Finding]
    text: str = ""
    time: Optional[np.ndarray] = None
    measured: Optional[np.ndarray] = None
    simulated: Optional[np.ndarray] = None
    _content: dict = dataclasses.field(default_factory=dict, repr=False, compare=False)

    @staticmethod
    def from_dict(content: Mapping, text: str = "", arrays: Optional[Mapping] = None) -> "Estimate":
        """From the content of a file that `heft estimate --json` wrote."""
        same = ("trust", "method", "parameters", "bias", "physically_consistent", "identifiability", "conventions",
                "evidence", "residual", "recording", "sensor_mount", "termination", "timing_s")
        return Estimate(
            payload=Payload.from_dict(content["payload"]), std=Payload.from_dict(content["std"]),
            interval95=Interval95.from_dict(content["interval95"]),
            segments=[Segment(**segment) for segment in content.get("segments", [])],
            findings=Finding.list_from(content.get("findings", [])), text=text, _content=dict(content),
            **{key: content.get(key) for key in same}, **dict(arrays or {}))

    @staticmethod
    def from_core(core: Any) -> "Estimate":
        arrays = {name: core.array(name) for name in ("time", "measured", "simulated")}
        return Estimate.from_dict(json.loads(core.json()), core.text(), arrays)

    def plot(self, axes=None):
        """Measured and simulated wrench by matplotlib; `axes`: two of them, for force and torque. Returns them."""
        from .plots import wrenches
        return wrenches(self.time, [("measured", self.measured), ("simulated", self.simulated)], axes)


@dataclasses.dataclass(frozen=True)
class Cause:
    """One thing that the simulation gets wrong; `when`: segments [s], empty for throughout."""

    cause: str
    title: str
    text: str
    check: str
    parameters: Any
    evidence: dict
    gain: dict
    when: list
    direct: bool
    alternatives: list
    tell_apart: str


@dataclasses.dataclass(frozen=True)
class Diagnosis(_FromJson):
    """A heft.diagnose/1. `verdict`: "clean", "explained", "ambiguous" or "unexplained".

    `before` and `after` are the estimates from the recording and with the causes taken out. `time` (N,), `measured`,
    `simulated_before` and `simulated_after` (N, 6): wrench without and with the causes, each block predicted by what was
    fitted without it.
    """

    verdict: str
    sentence: str
    causes: list[Cause]
    before: Estimate
    after: Estimate
    baseline: dict
    remaining: dict
    meta_changes: dict
    findings: list[Finding]
    text: str = ""
    time: Optional[np.ndarray] = None
    measured: Optional[np.ndarray] = None
    simulated_before: Optional[np.ndarray] = None
    simulated_after: Optional[np.ndarray] = None
    _content: dict = dataclasses.field(default_factory=dict, repr=False, compare=False)

    @staticmethod
    def from_core(core: Any) -> "Diagnosis":
        content = json.loads(core.json())
        names = {field.name for field in dataclasses.fields(Cause)}
        causes = [Cause(**{name: cause.get(name) for name in names}) for cause in content["causes"]]
        return Diagnosis(
            verdict=content["verdict"], sentence=content["text"], causes=causes,
            before=Estimate.from_dict(json.loads(core.before_json())),
            after=Estimate.from_dict(json.loads(core.after_json())), baseline=content["baseline"],
            remaining=content["remaining"], meta_changes=content["meta_changes"],
            findings=Finding.list_from(content["findings"]), text=core.text(), time=core.array("time"),
            measured=core.array("measured"), simulated_before=core.array("before"), simulated_after=core.array("after"),
            _content=content)

    def plot(self, axes=None):
        """What the simulation misses, without and with the causes; `axes`: two of them. Returns them."""
        from .plots import wrenches
        return wrenches(self.time, [("missed before", self.measured - self.simulated_before),
                                    ("missed after", self.measured - self.simulated_after)], axes)


@dataclasses.dataclass(frozen=True)
class Compensation(_FromJson):
    """A heft.compensate/1. `wrench` (N, 6): without the payload's share and bias, on the recording's rows; `phase`: of
    each row, "free", "approach", "contact" or "ignore"."""

    time: np.ndarray
    wrench: np.ndarray
    phase: np.ndarray
    findings: list[Finding]
    _content: dict = dataclasses.field(default_factory=dict, repr=False, compare=False)

    @staticmethod
    def from_core(core: Any, recording: Any) -> "Compensation":
        content = json.loads(core.json(recording))
        return Compensation(core.array("time"), core.array("wrench"), np.array(core.phases()),
                            Finding.list_from(content["findings"]), content)

    def plot(self, axes=None):
        """The compensated wrench by matplotlib; `axes`: two of them. Returns them."""
        from .plots import wrenches
        return wrenches(self.time, [("without the payload", self.wrench)], axes)


@dataclasses.dataclass(frozen=True)
class Exported:
    """A payload file's text, and what is to be known about it."""

    text: str
    findings: list[Finding]
