# Heft 0.0, recording demo.csv -- method map
# 95 %: mass 0.7521 to 0.7547 kg; centre of mass +-0.4 mm; inertia +-7 %
# Load for xArm-Python-SDK: mass [kg], centre of mass from the flange [mm]; it has no inertia.
# arm is your XArmAPI; arm.save_conf() keeps the load over a restart.
arm.set_tcp_load(0.753422, [12.346, -4.5, 67.891])
