MODULE heft_Gripper___flange__A_
  ! Heft 0.0, recording demo.csv -- method map
  ! 95 %: mass 0.7521 to 0.7547 kg; centre of mass +-0.4 mm; inertia +-7 %
  ! loaddata: mass [kg], centre of gravity from the flange [mm], principal axes [q1..q4, q1 real], principal moments about the centre of gravity [kg m2].
  PERS loaddata load_Gripper___flange__A_ := [0.753422,[12.346,-4.5,67.891],[0.949556019,0.16849266,-0.058855937,0.257855714],0.0030999941,0.00270000368,0.00110000222];
ENDMODULE
