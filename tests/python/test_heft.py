"""The Python module against the command line: the same numbers, the same sentences, no copies, no lock."""
import json
import os
import subprocess
import sys
import threading

import numpy as np
import pytest

import heft

HEFT = os.environ["HEFT"]


def command(*arguments):
    return subprocess.run([HEFT, *map(str, arguments)], capture_output=True, text=True)


@pytest.fixture(scope="module")
def rec(tmp_path_factory):
    csv = tmp_path_factory.mktemp("rec") / "rec.csv"
    assert command("simulate", "--motion", "free", "--seed", 3, "--duration", 8, "--effect", "cable_pull=4", "-o", csv).returncode == 0
    return csv


def without_times(content):
    """Processor times differ from run to run."""
    return {key: value for key, value in content.items() if key != "timing_s"}


def test_arrays_are_views_of_the_recording(rec):
    recording = heft.open(rec)
    assert len(recording) == 8000 and recording.rate_hz == pytest.approx(1000.0)
    assert recording.time.shape == (8000,) and recording.q.shape == (8000, 7) and recording.wrench.shape == (8000, 6)
    assert recording.position is None and recording.quaternion is None
    assert np.shares_memory(recording.wrench, recording.wrench) and not recording.wrench.flags.writeable
    wrench = recording.wrench
    del recording
    assert np.isfinite(wrench).all()  # the array keeps its recording alive
    rows = np.loadtxt(rec, delimiter=",", skiprows=1, max_rows=5)
    assert (wrench[:5] == rows[:, -6:]).all()


def test_estimate_is_that_of_the_command_line_bit_for_bit(rec):
    told = json.loads(command("estimate", rec, "--json", "-").stdout)
    result = heft.estimate(heft.open(rec))
    assert without_times(result.to_dict()) == without_times(told)
    assert result.payload.mass_kg == told["payload"]["mass_kg"]
    assert result.interval95.inertia_com_kgm2.shape == (3, 3, 2)
    assert (result.payload.inertia_com_kgm2 == np.array(told["payload"]["inertia_com_kgm2"])).all()
    assert [f.code for f in result.findings] == [f["code"] for f in told["findings"]]
    assert result.measured.shape == result.simulated.shape == (len(result.time), 6)


def test_options_are_those_of_the_command_line(rec):
    told = json.loads(command("estimate", rec, "--json", "-", "--method", "ls", "--trim", 0.2, "--shape",
                              "box:0.06,0.06,0.16", "--mass", 0.8).stdout)
    result = heft.estimate(rec, method="ls", trim=0.2, shape="box:0.06,0.06,0.16", mass=0.8)
    assert without_times(result.to_dict()) == without_times(told)


def test_ceres_is_found_when_it_is_asked_for(rec):
    assert heft.estimate(rec, method="ceres").to_dict()["termination"]["usable"]


def test_diagnosis_names_the_hidden_cable(rec):
    told = json.loads(command("diagnose", rec, "--json", "-").stdout)
    found = heft.diagnose(rec)
    assert without_times(found.to_dict()) == without_times(told)
    assert "cable_pull" in [cause.cause for cause in found.causes]
    missed = lambda simulated: np.sqrt(np.mean((found.measured - simulated)[:, :3] ** 2))
    assert missed(found.simulated_after) < missed(found.simulated_before)
    assert found.after.payload.mass_kg == pytest.approx(0.8, rel=0.02)


def test_compensation_and_export(rec, tmp_path):
    result = heft.estimate(rec)
    compensated = heft.compensate(rec, result)
    assert compensated.wrench.shape == (8000, 6) and set(compensated.phase) <= {"free", "approach", "contact", "ignore"}
    kept = tmp_path / "result.json"
    command("estimate", rec, "--json", kept)
    told = command("export", kept, "--format", "libfranka").stdout
    written = heft.export(result, "libfranka", tmp_path / "tool.txt")
    assert (tmp_path / "tool.txt").read_text() == written.text
    numbers = lambda text: [line for line in text.splitlines() if not line.lstrip().startswith(("//", "#"))]
    assert numbers(written.text) == numbers(told)
    with pytest.raises(heft.Error, match="exists"):
        heft.export(result, "libfranka", tmp_path / "tool.txt")
    assert "urdf" in heft.export_formats()


def test_arrays_make_the_same_recording(rec):
    file = heft.open(rec)
    meta = json.loads(rec.with_suffix(".meta.json").read_text())
    made = heft.Recording.from_arrays(file.time, file.wrench, q=file.q, dq=file.dq, meta=meta)
    one, other = heft.estimate(file), heft.estimate(made)
    assert one.payload.mass_kg == other.payload.mass_kg
    with pytest.raises(heft.Error, match="wrench needs 8000 rows"):
        heft.Recording.from_arrays(file.time, file.wrench[:-1], q=file.q, meta=meta)
    with pytest.raises(heft.Error, match="6 joints"):
        heft.estimate(heft.Recording.from_arrays(file.time, file.wrench, q=file.q[:, :6], meta=meta))


def test_simulation_repeats_itself():
    one = heft.simulate("free", duration_s=2, seed=5, effects=["bias_drift=0.5"])
    other = heft.simulate("free", duration_s=2, seed=5, effects=["bias_drift=0.5"])
    assert (one.wrench == other.wrench).all()
    assert one.truth["payload"]["mass_kg"] == pytest.approx(0.8)


def test_errors_are_the_sentences_of_the_command_line(tmp_path):
    bad = tmp_path / "bad.csv"
    bad.write_text("time,fx,fy,fz,tx,ty,tz\n0,1,2,3,x,5,6\n")
    with pytest.raises(heft.Error) as raised:
        heft.open(bad)
    assert str(raised.value) in command("estimate", bad).stderr.replace("heft estimate: ", "")
    with pytest.raises(heft.Error, match="one of map"):
        heft.estimate(heft.simulate(duration_s=2), method="guess")


def test_progress_cancels_and_passes_exceptions_on(rec):
    seen = []
    heft.estimate(rec, progress=lambda fraction, what: seen.append((fraction, what)))
    assert seen and all(0.0 <= fraction <= 1.0 for fraction, _ in seen)
    with pytest.raises(heft.Cancelled):
        heft.diagnose(rec, progress=lambda fraction, what: False)
    with pytest.raises(ZeroDivisionError):
        heft.diagnose(rec, progress=lambda fraction, what: 1 / 0)


def test_other_threads_run_meanwhile(rec):
    recording, ticks, done = heft.open(rec), [], threading.Event()

    def tick():
        while not done.wait(0.001):
            ticks.append(1)

    thread = threading.Thread(target=tick)
    thread.start()
    heft.diagnose(recording)
    done.set()
    thread.join()
    assert len(ticks) > 20  # with the lock held it would be one or two


def test_plots(rec):
    pytest.importorskip("matplotlib")
    assert len(heft.estimate(rec).plot()) == 2
    assert len(heft.diagnose(rec).plot()) == 2


def test_example_script(rec):
    example = os.path.join(os.path.dirname(__file__), "..", "..", "app", "python", "examples", "one_recording.py")
    run = subprocess.run([sys.executable, example, str(rec)], capture_output=True, text=True, cwd=rec.parent)
    assert run.returncode == 0, run.stderr
    assert "cable" in run.stdout.lower() and (rec.parent / "rec.png").stat().st_size > 10000
