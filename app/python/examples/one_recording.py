# What a notebook would do with one recording: look, estimate, ask what the simulation gets wrong, plot, export.
# python3 one_recording.py rec.csv
# %%
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import heft

file = Path(sys.argv[1])
recording = heft.open(file)
print(recording)
print("largest force:", abs(recording.wrench[:, :3]).max(), "N")

# %% The payload, and how far each number can be trusted
result = heft.estimate(recording)
low, high = result.interval95.mass_kg
print(f"{result.payload.mass_kg:.4f} kg, 95 %: {low:.4f} to {high:.4f} kg; trust: {result.trust}")
for finding in result.findings:
    print(finding.severity + ":", finding.text, finding.remedy)

# %% What does the simulation get wrong?
found = heft.diagnose(recording)
print(found.sentence)
for cause in found.causes:
    print("-", cause.title + ":", cause.text, "Check:", cause.check)
axes = found.plot()
axes[0].figure.savefig(file.with_suffix(".png"))

# %% With the causes taken out, for the controller
better = found.after
print(f"mass {result.payload.mass_kg:.4f} -> {better.payload.mass_kg:.4f} kg")
if better.trust != "none":
    print(heft.export(better, "libfranka").text)
