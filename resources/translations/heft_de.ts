<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>ExportText</name>
    <message>
        <source>Franka Desk</source>
        <translation>Franka Desk</translation>
    </message>
    <message>
        <source>end effector, JSON</source>
        <translation>Endeffektor, JSON</translation>
    </message>
    <message>
        <source>Franka profile</source>
        <translation>Franka-Profil</translation>
    </message>
    <message>
        <source>libfranka</source>
        <translation>libfranka</translation>
    </message>
    <message>
        <source>setLoad, C++</source>
        <translation>setLoad, C++</translation>
    </message>
    <message>
        <source>ROS 1</source>
        <translation>ROS 1</translation>
    </message>
    <message>
        <source>franka_ros, YAML</source>
        <translation>franka_ros, YAML</translation>
    </message>
    <message>
        <source>ROS 2</source>
        <translation>ROS 2</translation>
    </message>
    <message>
        <source>franka_ros2, YAML</source>
        <translation>franka_ros2, YAML</translation>
    </message>
    <message>
        <source>URDF</source>
        <translation>URDF</translation>
    </message>
    <message>
        <source>link with inertia</source>
        <translation>Glied mit Trägheit</translation>
    </message>
    <message>
        <source>SDFormat</source>
        <translation>SDFormat</translation>
    </message>
    <message>
        <source>Gazebo model</source>
        <translation>Gazebo-Modell</translation>
    </message>
    <message>
        <source>MuJoCo</source>
        <translation>MuJoCo</translation>
    </message>
    <message>
        <source>body, XML</source>
        <translation>Körper, XML</translation>
    </message>
    <message>
        <source>UR</source>
        <translation>UR</translation>
    </message>
    <message>
        <source>URScript</source>
        <translation>URScript</translation>
    </message>
    <message>
        <source>KUKA</source>
        <translation>KUKA</translation>
    </message>
    <message>
        <source>LOAD_DATA</source>
        <translation>LOAD_DATA</translation>
    </message>
    <message>
        <source>ABB</source>
        <translation>ABB</translation>
    </message>
    <message>
        <source>loaddata</source>
        <translation>loaddata</translation>
    </message>
    <message>
        <source>FANUC</source>
        <translation>FANUC</translation>
    </message>
    <message>
        <source>payload schedule</source>
        <translation>Payload-Tabelle</translation>
    </message>
    <message>
        <source>Heft JSON</source>
        <translation>Heft JSON</translation>
    </message>
    <message>
        <source>for programs</source>
        <translation>für Programme</translation>
    </message>
    <message>
        <source>This file sets the load on top of the end effector. The robot’s own tool belongs into Franka Desk; stated in both, its weight counts twice.</source>
        <translation>Diese Datei setzt die Last zusätzlich zum Endeffektor. Das eigene Werkzeug des Roboters gehört in Franka Desk; an beiden Stellen angegeben, zählt sein Gewicht doppelt.</translation>
    </message>
    <message>
        <source>This file describes the robot’s own end effector. Something that it picked up belongs into setLoad (libfranka or ROS), added to the tool that is already there.</source>
        <translation>Diese Datei beschreibt den eigenen Endeffektor des Roboters. Was er aufgenommen hat, gehört in setLoad (libfranka oder ROS), zusätzlich zum Werkzeug, das schon da ist.</translation>
    </message>
    <message>
        <source>A UR wants tool and load together in one number: tick the tool under “What else is mounted?”.</source>
        <translation>Ein UR will Werkzeug und Last zusammen in einer Zahl: Haken Sie das Werkzeug unter „Was ist noch angebaut?“ an.</translation>
    </message>
    <message>
        <source>The mass is not known from this motion.</source>
        <translation>Die Masse ist aus dieser Bewegung nicht bekannt.</translation>
    </message>
    <message>
        <source>The inertia is not known from this motion; the file holds a plausible size only. Fine for slow work; record faster turns for fast work.</source>
        <translation>Die Trägheit ist aus dieser Bewegung nicht bekannt; die Datei enthält nur eine plausible Größe. Gut für langsame Arbeit; nehmen Sie für schnelle Arbeit schnellere Drehungen auf.</translation>
    </message>
    <message>
        <source>The inertia rests on your shape, not on your motion. Fine for slow work; record faster turns for fast work.</source>
        <translation>Die Trägheit beruht auf Ihrer Form, nicht auf der Bewegung. Gut für langsame Arbeit; nehmen Sie für schnelle Arbeit schnellere Drehungen auf.</translation>
    </message>
    <message>
        <source>A real body can have these numbers.</source>
        <translation>Ein wirklicher Körper kann diese Werte haben.</translation>
    </message>
    <message>
        <source>Well inside the arm’s limit of %1 kg.</source>
        <translation>Deutlich unter der Grenze des Arms von %1 kg.</translation>
    </message>
</context>
<context>
    <name>MarkText</name>
    <message>
        <source>%1 – %2 s</source>
        <translation>%1 – %2 s</translation>
    </message>
    <message>
        <source>very sure</source>
        <translation>sehr sicher</translation>
    </message>
    <message>
        <source>fairly sure</source>
        <translation>ziemlich sicher</translation>
    </message>
    <message>
        <source>not sure</source>
        <translation>nicht sicher</translation>
    </message>
    <message numerus="yes">
        <source>Only free parts are used. Please check %n stretch(es).</source>
        <translation>
            <numerusform>Nur freie Teile werden benutzt. Bitte prüfen Sie %n Abschnitt.</numerusform>
            <numerusform>Nur freie Teile werden benutzt. Bitte prüfen Sie %n Abschnitte.</numerusform>
        </translation>
    </message>
    <message>
        <source>Heft found nothing that touched the tool.</source>
        <translation>Heft fand nichts, was das Werkzeug berührt hat.</translation>
    </message>
    <message>
        <source>Only free parts are used.</source>
        <translation>Nur freie Teile werden benutzt.</translation>
    </message>
</context>
<context>
    <name>MenuBuilder</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;Practice</source>
        <translation>&amp;Üben</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>S&amp;tep</source>
        <translation>S&amp;chritt</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Opened &amp;lately</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Save the session</source>
        <translation>Sitzung &amp;speichern</translation>
    </message>
    <message>
        <source>Save the session &amp;as …</source>
        <translation>Sitzung speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Payload &amp;file …</source>
        <translation>&amp;Payload-Datei …</translation>
    </message>
    <message>
        <source>Save a &amp;picture of the window …</source>
        <translation>&amp;Bild des Fensters speichern …</translation>
    </message>
    <message>
        <source>window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Whole arm</source>
        <translation>&amp;Ganzer Arm</translation>
    </message>
    <message>
        <source>&amp;Tool</source>
        <translation>&amp;Werkzeug</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>&amp;Side</source>
        <translation>&amp;Seite</translation>
    </message>
    <message>
        <source>T&amp;op</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>Whole &amp;recording in the plots</source>
        <translation>Ganze &amp;Aufnahme in den Kurven</translation>
    </message>
    <message>
        <source>&amp;Details</source>
        <translation>&amp;Einzelheiten</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>L&amp;anguage</source>
        <translation>S&amp;prache</translation>
    </message>
    <message>
        <source>&amp;Estimate again</source>
        <translation>&amp;Noch einmal schätzen</translation>
    </message>
    <message>
        <source>&amp;Stop the work under way</source>
        <translation>Laufende Arbeit an&amp;halten</translation>
    </message>
    <message>
        <source>&amp;About Heft Studio</source>
        <translation>Ü&amp;ber Heft Studio</translation>
    </message>
    <message>
        <source>About Heft Studio</source>
        <translation>Über Heft Studio</translation>
    </message>
    <message>
        <source>Heft Studio %1</source>
        <translation>Heft Studio %1</translation>
    </message>
    <message>
        <source>Finds out what a robot arm carries. Heft’s source is under the Apache License 2.0; this program links QCustomPlot and may be passed on under the GNU General Public License, version 3 or later.</source>
        <translation>Findet heraus, was ein Roboterarm trägt. Der Quelltext von Heft steht unter der Apache-Lizenz 2.0; dieses Programm bindet QCustomPlot ein und darf unter der GNU General Public License, Version 3 oder später, weitergegeben werden.</translation>
    </message>
</context>
<context>
    <name>MethodTable</name>
    <message>
        <source>Heft’s own (MAP)</source>
        <translation>Hefts eigenes (MAP)</translation>
    </message>
    <message>
        <source>least squares</source>
        <translation>kleinste Quadrate</translation>
    </message>
    <message>
        <source>weighted least squares</source>
        <translation>gewichtete kleinste Quadrate</translation>
    </message>
    <message>
        <source>total least squares</source>
        <translation>totale kleinste Quadrate</translation>
    </message>
    <message>
        <source>total least squares, fast</source>
        <translation>totale kleinste Quadrate, schnell</translation>
    </message>
    <message>
        <source>total least squares, exact</source>
        <translation>totale kleinste Quadrate, exakt</translation>
    </message>
    <message>
        <source>Ceres</source>
        <translation>Ceres</translation>
    </message>
    <message>
        <source>Levenberg-Marquardt</source>
        <translation>Levenberg-Marquardt</translation>
    </message>
    <message>
        <source>brute force</source>
        <translation>Ausprobieren</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>How the numbers were found</source>
        <translation>Wie die Werte gefunden wurden</translation>
    </message>
    <message>
        <source>Mass [kg]</source>
        <translation>Masse [kg]</translation>
    </message>
    <message>
        <source>With half the width of its 95 % interval</source>
        <translation>Mit der halben Breite ihres 95-%-Intervalls</translation>
    </message>
    <message>
        <source>Centre x, y, z [mm]</source>
        <translation>Schwerpunkt x, y, z [mm]</translation>
    </message>
    <message>
        <source>From the sensor’s origin, sensor axes</source>
        <translation>Vom Ursprung des Sensors, Sensorachsen</translation>
    </message>
    <message>
        <source>Inertia [kg cm²]</source>
        <translation>Trägheit [kg cm²]</translation>
    </message>
    <message>
        <source>Sum of Ixx, Iyy and Izz about the centre of mass</source>
        <translation>Summe von Ixx, Iyy und Izz um den Schwerpunkt</translation>
    </message>
    <message>
        <source>Unseen force [N]</source>
        <translation>Ungesehen, Kraft [N]</translation>
    </message>
    <message>
        <source>Error on parts of the motion that the method did not see</source>
        <translation>Fehler auf Teilen der Bewegung, die das Verfahren nicht gesehen hat</translation>
    </message>
    <message>
        <source>Unseen torque [N m]</source>
        <translation>Ungesehen, Moment [N m]</translation>
    </message>
    <message>
        <source>Mass off [%]</source>
        <translation>Masse daneben [%]</translation>
    </message>
    <message>
        <source>Relative error against the known value</source>
        <translation>Relativer Fehler gegen den bekannten Wert</translation>
    </message>
    <message>
        <source>Centre off [%]</source>
        <translation>Schwerpunkt daneben [%]</translation>
    </message>
    <message>
        <source>Inertia off [%]</source>
        <translation>Trägheit daneben [%]</translation>
    </message>
    <message>
        <source>Relative error about the sensor’s origin, against the known value</source>
        <translation>Relativer Fehler um den Ursprung des Sensors, gegen den bekannten Wert</translation>
    </message>
    <message>
        <source>Time [ms]</source>
        <translation>Zeit [ms]</translation>
    </message>
    <message>
        <source>From the prepared motion to the numbers</source>
        <translation>Von der vorbereiteten Bewegung zu den Werten</translation>
    </message>
    <message>
        <source>Can it be so?</source>
        <translation>Kann es so sein?</translation>
    </message>
    <message>
        <source>Whether a real body can have these numbers</source>
        <translation>Ob ein wirklicher Körper diese Werte haben kann</translation>
    </message>
    <message>
        <source>no result</source>
        <translation>kein Ergebnis</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
</context>
<context>
    <name>ResultText</name>
    <message>
        <source>%1
95 % interval: %2 to %3 %4</source>
        <translation>%1
95-%-Intervall: %2 bis %3 %4</translation>
    </message>
    <message>
        <source>Mass, centre and inertia are measured.</source>
        <translation>Masse, Schwerpunkt und Trägheit sind gemessen.</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>Schwerpunkt</translation>
    </message>
    <message>
        <source>inertia</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>%1, %2 and %3</source>
        <translation>%1, %2 und %3</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>%1 are measured</source>
        <translation>%1 sind gemessen</translation>
    </message>
    <message>
        <source>%1 is measured</source>
        <translation>%1 ist gemessen</translation>
    </message>
    <message>
        <source>%1 lean on what you stated</source>
        <translation>%1 stützen sich auf Ihre Angaben</translation>
    </message>
    <message>
        <source>%1 leans on what you stated</source>
        <translation>%1 stützt sich auf Ihre Angaben</translation>
    </message>
    <message>
        <source>%1 are not fully known from this motion</source>
        <translation>%1 sind aus dieser Bewegung nicht ganz bekannt</translation>
    </message>
    <message>
        <source>%1 is not fully known from this motion</source>
        <translation>%1 ist aus dieser Bewegung nicht ganz bekannt</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>.</source>
        <translation>.</translation>
    </message>
    <message>
        <source>How hard the tool is to turn about its own axis %1</source>
        <translation>Wie schwer das Werkzeug um seine eigene Achse %1 zu drehen ist</translation>
    </message>
    <message>
        <source>How turning about %1 pushes about %2</source>
        <translation>Wie Drehen um %1 um %2 drückt</translation>
    </message>
    <message>
        <source>Ixy, Ixz, Iyz</source>
        <translation>Ixy, Ixz, Iyz</translation>
    </message>
    <message>
        <source>Products of inertia; the widest of the three intervals</source>
        <translation>Deviationsmomente; das breiteste der drei Intervalle</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>How the numbers were found</source>
        <translation>Wie die Werte gefunden wurden</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>Benutzt</translation>
    </message>
    <message>
        <source>%1 of %2 s, %3 Hz</source>
        <translation>%1 von %2 s, %3 Hz</translation>
    </message>
    <message>
        <source>Free parts without the ends that were trimmed</source>
        <translation>Freie Teile ohne die abgeschnittenen Enden</translation>
    </message>
    <message>
        <source>Left over, force</source>
        <translation>Rest, Kraft</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Root mean square of the difference, free parts</source>
        <translation>Quadratisches Mittel der Differenz, freie Teile</translation>
    </message>
    <message>
        <source>Left over, torque</source>
        <translation>Rest, Moment</translation>
    </message>
    <message>
        <source>%1 N m</source>
        <translation>%1 N m</translation>
    </message>
    <message>
        <source>On unseen parts</source>
        <translation>Auf ungesehenen Teilen</translation>
    </message>
    <message>
        <source>%1 N, %2 N m</source>
        <translation>%1 N, %2 N m</translation>
    </message>
    <message>
        <source>The same on parts that the estimate did not see</source>
        <translation>Dasselbe auf Teilen, die die Schätzung nicht gesehen hat</translation>
    </message>
    <message>
        <source>Sensor zero, force</source>
        <translation>Sensornullpunkt, Kraft</translation>
    </message>
    <message>
        <source>Constant offset x, y, z of the sensor</source>
        <translation>Fester Versatz x, y, z des Sensors</translation>
    </message>
    <message>
        <source>Sensor zero, torque</source>
        <translation>Sensornullpunkt, Moment</translation>
    </message>
    <message>
        <source>Condition number</source>
        <translation>Konditionszahl</translation>
    </message>
    <message>
        <source>Of the scaled, whitened regressor: how unevenly the motion tells the ten parameters</source>
        <translation>Des skalierten, geweißten Regressors: wie ungleich die Bewegung über die zehn Parameter Auskunft gibt</translation>
    </message>
    <message>
        <source>mass %1 %</source>
        <translation>Masse %1 %</translation>
    </message>
    <message>
        <source>centre %1 %</source>
        <translation>Schwerpunkt %1 %</translation>
    </message>
    <message>
        <source>inertia %1 %</source>
        <translation>Trägheit %1 %</translation>
    </message>
    <message>
        <source>Off what you stated</source>
        <translation>Abstand zu Ihren Angaben</translation>
    </message>
    <message>
        <source>Relative error |estimate − stated| / |stated|</source>
        <translation>Relativer Fehler |Schätzung − Angabe| / |Angabe|</translation>
    </message>
    <message>
        <source>A real body could be so</source>
        <translation>Ein wirklicher Körper könnte so sein</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Positive mass and an inertia that some distribution of mass can have</source>
        <translation>Positive Masse und eine Trägheit, die irgendeine Massenverteilung haben kann</translation>
    </message>
    <message>
        <source>Time to compute</source>
        <translation>Rechenzeit</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Preparing and solving</source>
        <translation>Vorbereiten und Lösen</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>from your shape</source>
        <translation>aus Ihrer Form</translation>
    </message>
    <message>
        <source>not known from this motion</source>
        <translation>aus dieser Bewegung nicht bekannt</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>kg</source>
        <translation>kg</translation>
    </message>
    <message>
        <source>Mass of the tool</source>
        <translation>Masse des Werkzeugs</translation>
    </message>
    <message>
        <source> kg</source>
        <translation> kg</translation>
    </message>
    <message>
        <source>you stated %1 kg, %2 % away</source>
        <translation>Ihre Angabe: %1 kg, %2 % entfernt</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Centre of mass from the sensor&apos;s origin along its axis %1</source>
        <translation>Schwerpunkt vom Ursprung des Sensors entlang seiner Achse %1</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>%1 mm from the centre you stated</source>
        <translation>%1 mm vom angegebenen Schwerpunkt</translation>
    </message>
    <message>
        <source>kg mm²</source>
        <translation>kg mm²</translation>
    </message>
    <message>
        <source>kg cm²</source>
        <translation>kg cm²</translation>
    </message>
    <message>
        <source>%1 % from the inertia you stated</source>
        <translation>%1 % von der angegebenen Trägheit</translation>
    </message>
    <message>
        <source>This motion does not tell the mass.</source>
        <translation>Diese Bewegung verrät die Masse nicht.</translation>
    </message>
    <message>
        <source>Your tool weighs %1 kg.</source>
        <translation>Ihr Werkzeug wiegt %1 kg.</translation>
    </message>
    <message>
        <source>Check the warnings first: these numbers may be off by more than they say.</source>
        <translation>Prüfen Sie zuerst die Warnungen: Diese Werte können weiter daneben liegen, als sie sagen.</translation>
    </message>
    <message>
        <source>The motion alone said %1 %3, you said %2 %3.</source>
        <translation>Die Bewegung allein sagte %1 %3, Sie sagten %2 %3.</translation>
    </message>
    <message>
        <source>That moved the result by %1 σ.</source>
        <translation>Das verschob das Ergebnis um %1 σ.</translation>
    </message>
    <message>
        <source>%1 % data</source>
        <translation>%1 % Daten</translation>
    </message>
    <message>
        <source>%1 % what you stated</source>
        <translation>%1 % Ihre Angaben</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Schwerpunkt</translation>
    </message>
    <message>
        <source>Inertia</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>%1 kg known, %2 % away</source>
        <translation>%1 kg bekannt, %2 % entfernt</translation>
    </message>
    <message>
        <source>|estimate − known| / known</source>
        <translation>|Schätzung − bekannt| / bekannt</translation>
    </message>
    <message>
        <source>%1 mm away</source>
        <translation>%1 mm entfernt</translation>
    </message>
    <message>
        <source> (%1 %)</source>
        <translation> (%1 %)</translation>
    </message>
    <message>
        <source>Centre of mass</source>
        <translation>Schwerpunkt</translation>
    </message>
    <message>
        <source>|estimate − known|, and by the length of the known</source>
        <translation>|Schätzung − bekannt|, und bezogen auf die Länge des bekannten</translation>
    </message>
    <message>
        <source>%1 % away, about the sensor %2 %</source>
        <translation>%1 % entfernt, um den Sensor %2 %</translation>
    </message>
    <message>
        <source>‖estimate − known‖ / ‖known‖, Frobenius, about the centre of mass and about the sensor’s origin</source>
        <translation>‖Schätzung − bekannt‖ / ‖bekannt‖, Frobenius, um den Schwerpunkt und um den Ursprung des Sensors</translation>
    </message>
</context>
<context>
    <name>Steps</name>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Markieren</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Reality check</source>
        <translation>Realitätsprüfung</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Ausgeben</translation>
    </message>
</context>
<context>
    <name>heft</name>
    <message>
        <source>pose %1</source>
        <translation>Stellung %1</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>partly measured</source>
        <translation>teils gemessen</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>look here</source>
        <translation>hier hinsehen</translation>
    </message>
    <message>
        <source>two causes</source>
        <translation>zwei Ursachen</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>nicht möglich</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Hinweis</translation>
    </message>
</context>
<context>
    <name>heft::DifferenceCursor</name>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>pose</source>
        <translation>Stellung</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
</context>
<context>
    <name>heft::ExportPanel</name>
    <message>
        <source>saved as %1</source>
        <translation>gespeichert als %1</translation>
    </message>
    <message>
        <source>nothing saved yet</source>
        <translation>noch nichts gespeichert</translation>
    </message>
    <message>
        <source>cannot be written yet</source>
        <translation>kann noch nicht geschrieben werden</translation>
    </message>
    <message>
        <source>ready to save</source>
        <translation>bereit zum Speichern</translation>
    </message>
    <message>
        <source>Sensor body</source>
        <translation>Sensorgehäuse</translation>
    </message>
    <message>
        <source>Sensor body, %1</source>
        <translation>Sensorgehäuse, %1</translation>
    </message>
    <message>
        <source>Where do the numbers go?</source>
        <translation>Wohin sollen die Werte?</translation>
    </message>
    <message>
        <source>First comes a result.</source>
        <translation>Zuerst kommt ein Ergebnis.</translation>
    </message>
    <message>
        <source>Go to the result</source>
        <translation>Zum Ergebnis</translation>
    </message>
    <message>
        <source>Go to Record</source>
        <translation>Zur Aufnahme</translation>
    </message>
    <message>
        <source>nothing to write yet</source>
        <translation>noch nichts zu schreiben</translation>
    </message>
    <message>
        <source>You see the whole file before anything is written.</source>
        <translation>Sie sehen die ganze Datei, bevor etwas geschrieben wird.</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Save the payload file …</source>
        <translation>Payload-Datei speichern …</translation>
    </message>
    <message>
        <source>This file cannot be written; see above.</source>
        <translation>Diese Datei kann nicht geschrieben werden; siehe oben.</translation>
    </message>
    <message>
        <source>Answer the question above first.</source>
        <translation>Beantworten Sie zuerst die Frage oben.</translation>
    </message>
    <message>
        <source>More …</source>
        <translation>Mehr …</translation>
    </message>
    <message numerus="yes">
        <source>%n format(s)</source>
        <translation>
            <numerusform>%n Format</numerusform>
            <numerusform>%n Formate</numerusform>
        </translation>
    </message>
    <message>
        <source>Is this the robot’s own tool, or something it picked up?</source>
        <translation>Ist das das eigene Werkzeug des Roboters oder etwas, das er aufgenommen hat?</translation>
    </message>
    <message>
        <source>Its own tool</source>
        <translation>Sein Werkzeug</translation>
    </message>
    <message>
        <source>An extra load</source>
        <translation>Eine Zusatzlast</translation>
    </message>
    <message>
        <source>Never state it as both: the controller would count the weight twice.</source>
        <translation>Nie als beides angeben: Die Steuerung würde das Gewicht doppelt zählen.</translation>
    </message>
    <message>
        <source>What else is mounted?</source>
        <translation>Was ist noch angebaut?</translation>
    </message>
    <message>
        <source>between flange and tool</source>
        <translation>zwischen Flansch und Werkzeug</translation>
    </message>
    <message>
        <source>Before you save</source>
        <translation>Vor dem Speichern</translation>
    </message>
    <message>
        <source>The sensor itself weighs something, too: tick it above unless the controller knows it already, or tick “Nothing else”.</source>
        <translation>Der Sensor selbst wiegt auch etwas: Haken Sie ihn oben an, wenn die Steuerung ihn noch nicht kennt, oder wählen Sie „Nichts weiter“.</translation>
    </message>
    <message>
        <source>choose the format</source>
        <translation>Format wählen</translation>
    </message>
    <message>
        <source>it is the robot’s own tool</source>
        <translation>es ist das eigene Werkzeug</translation>
    </message>
    <message>
        <source>it is an extra load</source>
        <translation>es ist eine Zusatzlast</translation>
    </message>
    <message>
        <source>Save the payload file</source>
        <translation>Payload-Datei speichern</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
    <message>
        <source>There is no payload file to save yet.</source>
        <translation>Es gibt noch keine Payload-Datei zu speichern.</translation>
    </message>
    <message>
        <source>%1 exists already and was not replaced.</source>
        <translation>%1 gibt es schon und wurde nicht ersetzt.</translation>
    </message>
    <message>
        <source>The file was copied to the clipboard.</source>
        <translation>Die Datei liegt in der Zwischenablage.</translation>
    </message>
    <message>
        <source>export expects a format and a file, and may end in replace: export franka-desk tool.json</source>
        <translation>export erwartet ein Format und eine Datei und darf auf replace enden: export franka-desk tool.json</translation>
    </message>
    <message>
        <source>There is no format %1; heft export --help lists them.</source>
        <translation>Es gibt kein Format %1; heft export --help zählt sie auf.</translation>
    </message>
    <message>
        <source>export needs a result.</source>
        <translation>export braucht ein Ergebnis.</translation>
    </message>
    <message>
        <source>An existing file is never replaced without asking</source>
        <translation>Eine vorhandene Datei wird nie ohne Rückfrage ersetzt</translation>
    </message>
    <message>
        <source>The sensor itself weighs something, too: add it under “Something else …” unless the controller knows it already, or tick “Nothing else”.</source>
        <translation>Der Sensor selbst wiegt auch etwas: Fügen Sie ihn unter „Etwas anderes …“ hinzu, wenn die Steuerung ihn noch nicht kennt, oder wählen Sie „Nichts weiter“.</translation>
    </message>
</context>
<context>
    <name>heft::FilePreview</name>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the whole file to the clipboard</source>
        <translation>Die ganze Datei in die Zwischenablage kopieren</translation>
    </message>
    <message>
        <source>The file before it is written</source>
        <translation>Die Datei, bevor sie geschrieben wird</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>gespeichert</translation>
    </message>
    <message>
        <source>not written yet</source>
        <translation>noch nicht geschrieben</translation>
    </message>
    <message>
        <source>Not told by the motion</source>
        <translation>Nicht aus der Bewegung bekannt</translation>
    </message>
</context>
<context>
    <name>heft::Files</name>
    <message>
        <source>Open recordings or a session</source>
        <translation>Aufnahmen oder eine Sitzung öffnen</translation>
    </message>
    <message>
        <source>Recordings and sessions (%1);;All files (*)</source>
        <translation>Aufnahmen und Sitzungen (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Sitzung speichern</translation>
    </message>
    <message>
        <source>Heft sessions (*.heft)</source>
        <translation>Heft-Sitzungen (*.heft)</translation>
    </message>
    <message>
        <source>%1 exists already and was not replaced: choose it in the dialog to replace it.</source>
        <translation>%1 gibt es schon und wurde nicht ersetzt: Wählen Sie die Datei im Dialog aus, um sie zu ersetzen.</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
    <message>
        <source>Heft Studio</source>
        <translation>Heft Studio</translation>
    </message>
    <message>
        <source>Save the session first?</source>
        <translation>Die Sitzung zuerst speichern?</translation>
    </message>
    <message>
        <source>Marks, shape and settings since the last save would be gone.</source>
        <translation>Marken, Form und Einstellungen seit dem letzten Speichern wären verloren.</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Noch nichts</translation>
    </message>
    <message>
        <source>Save a picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>%1 could not be written: check that the folder exists and may be written to.</source>
        <translation>%1 konnte nicht geschrieben werden: Prüfen Sie, ob es den Ordner gibt und ob man in ihn schreiben darf.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
</context>
<context>
    <name>heft::HeaderBar</name>
    <message>
        <source>Heft Studio</source>
        <translation>Heft Studio</translation>
    </message>
    <message>
        <source>Undo (Ctrl+Z)</source>
        <translation>Rückgängig (Strg+Z)</translation>
    </message>
    <message>
        <source>Redo (Ctrl+Y)</source>
        <translation>Wiederholen (Strg+Y)</translation>
    </message>
    <message>
        <source>Undo: %1 (Ctrl+Z)</source>
        <translation>Rückgängig: %1 (Strg+Z)</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>Nichts rückgängig zu machen</translation>
    </message>
    <message>
        <source>Redo: %1 (Ctrl+Y)</source>
        <translation>Wiederholen: %1 (Strg+Y)</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>Nichts zu wiederholen</translation>
    </message>
    <message>
        <source>Simple</source>
        <translation>Einfach</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>The result in plain words</source>
        <translation>Das Ergebnis in einfachen Worten</translation>
    </message>
    <message>
        <source>Also method, residuals and the sensor’s zero</source>
        <translation>Auch Verfahren, Reste und der Nullpunkt des Sensors</translation>
    </message>
</context>
<context>
    <name>heft::KnownValuesDialog</name>
    <message>
        <source>What do you know already?</source>
        <translation>Was wissen Sie schon?</translation>
    </message>
    <message>
        <source>From a scale or from CAD. Heft compares with it and changes nothing; leave empty what you do not know.</source>
        <translation>Von einer Waage oder aus CAD. Heft vergleicht damit und ändert nichts; lassen Sie leer, was Sie nicht wissen.</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Weight in kg</source>
        <translation>Gewicht in kg</translation>
    </message>
    <message>
        <source>Weight [kg]</source>
        <translation>Gewicht [kg]</translation>
    </message>
    <message>
        <source>Centre of mass %1 in mm</source>
        <translation>Schwerpunkt %1 in mm</translation>
    </message>
    <message>
        <source>Centre x, y, z [mm]</source>
        <translation>Schwerpunkt x, y, z [mm]</translation>
    </message>
    <message>
        <source>Inertia %1 in kg cm²</source>
        <translation>Trägheit %1 in kg cm²</translation>
    </message>
    <message>
        <source>Ixx, Iyy, Izz [kg cm²]</source>
        <translation>Ixx, Iyy, Izz [kg cm²]</translation>
    </message>
    <message>
        <source>Ixy, Ixz, Iyz [kg cm²]</source>
        <translation>Ixy, Ixz, Iyz [kg cm²]</translation>
    </message>
    <message>
        <source>Centre from the sensor’s origin, inertia about the centre of mass, along the sensor’s axes. Products as in the inertia matrix.</source>
        <translation>Schwerpunkt vom Ursprung des Sensors, Trägheit um den Schwerpunkt, entlang der Sensorachsen. Deviationsmomente wie in der Trägheitsmatrix.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>The weight should be a number above zero.</source>
        <translation>Das Gewicht muss eine Zahl über null sein.</translation>
    </message>
    <message>
        <source>The centre needs three numbers, or none.</source>
        <translation>Der Schwerpunkt braucht drei Zahlen oder keine.</translation>
    </message>
    <message>
        <source>The inertia needs Ixx, Iyy and Izz, or nothing; empty products count as zero.</source>
        <translation>Die Trägheit braucht Ixx, Iyy und Izz oder nichts; leere Deviationsmomente zählen als null.</translation>
    </message>
</context>
<context>
    <name>heft::LegendEntry</name>
    <message>
        <source>Show or hide: %1</source>
        <translation>Zeigen oder verbergen: %1</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
</context>
<context>
    <name>heft::MainWindow</name>
    <message>
        <source>Heft Studio</source>
        <translation>Heft Studio</translation>
    </message>
    <message>
        <source>view</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>plots</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Saved automatically, %1</source>
        <translation>Von selbst gespeichert, %1</translation>
    </message>
    <message>
        <source>Heft Studio ended without closing last time. What you had open was kept.</source>
        <translation>Heft Studio wurde beim letzten Mal nicht normal beendet. Was Sie offen hatten, ist noch da.</translation>
    </message>
    <message>
        <source>Open it again</source>
        <translation>Wieder öffnen</translation>
    </message>
    <message>
        <source>What was kept could not be read.</source>
        <translation>Was noch da war, konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>%1 – Heft Studio</source>
        <translation>%1 – Heft Studio</translation>
    </message>
    <message>
        <source>%1 standing poses</source>
        <translation>%1 Stellungen</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>No recording open</source>
        <translation>Keine Aufnahme offen</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>sichtbar</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
</context>
<context>
    <name>heft::MarkPanel</name>
    <message>
        <source>after recording</source>
        <translation>nach der Aufnahme</translation>
    </message>
    <message>
        <source>all poses are used</source>
        <translation>alle Stellungen benutzt</translation>
    </message>
    <message>
        <source>being looked at …</source>
        <translation>wird angesehen …</translation>
    </message>
    <message numerus="yes">
        <source>%n suggestion(s) to check</source>
        <translation>
            <numerusform>%n Vorschlag zu prüfen</numerusform>
            <numerusform>%n Vorschläge zu prüfen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 s free</source>
        <translation>%1 s frei</translation>
    </message>
    <message>
        <source>When did the tool touch nothing?</source>
        <translation>Wann hat das Werkzeug nichts berührt?</translation>
    </message>
    <message>
        <source>Open a recording first.</source>
        <translation>Öffnen Sie zuerst eine Aufnahme.</translation>
    </message>
    <message>
        <source>Go to Record</source>
        <translation>Zur Aufnahme</translation>
    </message>
    <message>
        <source>Standing poses are all used.</source>
        <translation>Ruhende Stellungen werden alle benutzt.</translation>
    </message>
    <message>
        <source>Heft is looking at the recording …</source>
        <translation>Heft sieht sich die Aufnahme an …</translation>
    </message>
    <message>
        <source>Heft suggests</source>
        <translation>Heft schlägt vor</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Accept it and go on</source>
        <translation>Übernehmen und weiter</translation>
    </message>
    <message>
        <source>Accept both and go on</source>
        <translation>Beide übernehmen, weiter</translation>
    </message>
    <message>
        <source>Accept all %1 and go on</source>
        <translation>Alle %1 übernehmen, weiter</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>ignore</source>
        <translation>ignorieren</translation>
    </message>
    <message>
        <source>Show this stretch</source>
        <translation>Diesen Abschnitt zeigen</translation>
    </message>
    <message>
        <source>Heft is</source>
        <translation>Heft ist</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Yes, contact</source>
        <translation>Ja, Kontakt</translation>
    </message>
    <message>
        <source>Yes, ignore</source>
        <translation>Ja, ignorieren</translation>
    </message>
    <message>
        <source>No, it was free</source>
        <translation>Nein, es war frei</translation>
    </message>
    <message>
        <source>All stretches</source>
        <translation>Alle Abschnitte</translation>
    </message>
    <message>
        <source>%1?</source>
        <translation>%1?</translation>
    </message>
    <message>
        <source>Or paint it yourself</source>
        <translation>Oder malen Sie selbst</translation>
    </message>
    <message>
        <source>drag over the marks</source>
        <translation>über die Marken ziehen</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Ignorieren</translation>
    </message>
    <message>
        <source>Paint with %1 (key %2). By keys: go to the marks bar, Enter begins, arrow keys move, Enter ends.</source>
        <translation>Mit %1 malen (Taste %2). Mit Tasten: zur Markenleiste gehen, Eingabe beginnt, Pfeiltasten bewegen, Eingabe beendet.</translation>
    </message>
    <message>
        <source>Paint as %1</source>
        <translation>Als %1 malen</translation>
    </message>
    <message>
        <source>Left to use</source>
        <translation>Bleibt zu benutzen</translation>
    </message>
    <message>
        <source>%1 s of %2 s are free. %3</source>
        <translation>%1 s von %2 s sind frei. %3</translation>
    </message>
    <message>
        <source>Enough for mass and centre.</source>
        <translation>Genug für Masse und Schwerpunkt.</translation>
    </message>
    <message>
        <source>Too little: record more, without touching anything.</source>
        <translation>Zu wenig: Nehmen Sie mehr auf, ohne etwas zu berühren.</translation>
    </message>
    <message>
        <source>accept suggestions</source>
        <translation>Vorschläge übernehmen</translation>
    </message>
    <message>
        <source>&amp;Mark the stretch shown</source>
        <translation>Gezeigten Abschnitt &amp;markieren</translation>
    </message>
    <message>
        <source>as &amp;free</source>
        <translation>als &amp;frei</translation>
    </message>
    <message>
        <source>as &amp;contact</source>
        <translation>als &amp;Kontakt</translation>
    </message>
    <message>
        <source>&amp;ignored</source>
        <translation>&amp;ignoriert</translation>
    </message>
    <message>
        <source>as Heft &amp;suggests</source>
        <translation>wie Heft &amp;vorschlägt</translation>
    </message>
    <message>
        <source>mark expects FROM TO and free, contact, ignore or suggested, for instance: mark 2.5 4 contact</source>
        <translation>mark erwartet VON BIS und free, contact, ignore oder suggested, zum Beispiel: mark 2.5 4 contact</translation>
    </message>
    <message>
        <source>mark needs an open recording.</source>
        <translation>mark braucht eine offene Aufnahme.</translation>
    </message>
    <message>
        <source>Drag an edge to move it · Ctrl+Z undoes</source>
        <translation>Eine Kante lässt sich verschieben · Strg+Z macht rückgängig</translation>
    </message>
</context>
<context>
    <name>heft::MarksBar</name>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>ignoriert</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Which stretches of the recording touched nothing</source>
        <translation>Welche Abschnitte der Aufnahme nichts berührt haben</translation>
    </message>
    <message>
        <source>standing poses, all used</source>
        <translation>ruhende Stellungen, alle benutzt</translation>
    </message>
    <message>
        <source>pose %1</source>
        <translation>Stellung %1</translation>
    </message>
</context>
<context>
    <name>heft::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>heft::MethodPane</name>
    <message>
        <source>All methods side by side</source>
        <translation>Alle Verfahren nebeneinander</translation>
    </message>
    <message>
        <source>Back to the plots</source>
        <translation>Zurück zu den Kurven</translation>
    </message>
    <message>
        <source>Every method weighs the tool in turn …</source>
        <translation>Jedes Verfahren wiegt das Werkzeug der Reihe nach …</translation>
    </message>
</context>
<context>
    <name>heft::MountedList</name>
    <message>
        <source>Is it between flange and tool, and not told to the controller elsewhere?</source>
        <translation>Sitzt es zwischen Flansch und Werkzeug, und weiß die Steuerung es nicht schon anderswoher?</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>%1 dazunehmen</translation>
    </message>
    <message>
        <source>leave out %1</source>
        <translation>%1 weglassen</translation>
    </message>
    <message>
        <source>%1 kg</source>
        <translation>%1 kg</translation>
    </message>
    <message>
        <source>Nothing else</source>
        <translation>Nichts weiter</translation>
    </message>
    <message>
        <source>nothing else is mounted</source>
        <translation>nichts weiter angebaut</translation>
    </message>
    <message>
        <source>Something else …</source>
        <translation>Etwas anderes …</translation>
    </message>
    <message>
        <source>Together on the flange</source>
        <translation>Zusammen am Flansch</translation>
    </message>
    <message>
        <source>Something else on the flange</source>
        <translation>Etwas anderes am Flansch</translation>
    </message>
    <message>
        <source>Adapter</source>
        <translation>Adapter</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Was es ist</translation>
    </message>
    <message>
        <source> kg</source>
        <translation> kg</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Centre from the flange, x</source>
        <translation>Schwerpunkt vom Flansch, x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Its inertia is taken as that of a compact aluminium body of this weight.</source>
        <translation>Seine Trägheit wird wie die eines kompakten Aluminiumkörpers dieses Gewichts angenommen.</translation>
    </message>
    <message>
        <source>Add it</source>
        <translation>Dazunehmen</translation>
    </message>
</context>
<context>
    <name>heft::PlaybackBar</name>
    <message>
        <source>Play (Space)</source>
        <translation>Abspielen (Leertaste)</translation>
    </message>
    <message>
        <source>Time in the recording</source>
        <translation>Zeit in der Aufnahme</translation>
    </message>
    <message>
        <source>Drag to move through the recording</source>
        <translation>Ziehen, um sich durch die Aufnahme zu bewegen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 von %2 s</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Anhalten (Leertaste)</translation>
    </message>
</context>
<context>
    <name>heft::RecordPanel</name>
    <message>
        <source>opening …</source>
        <translation>wird geöffnet …</translation>
    </message>
    <message>
        <source>nothing open yet</source>
        <translation>noch nichts offen</translation>
    </message>
    <message numerus="yes">
        <source>%n pose(s) recorded</source>
        <translation>
            <numerusform>%n Stellung aufgenommen</numerusform>
            <numerusform>%n Stellungen aufgenommen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 s recorded</source>
        <translation>%1 s aufgenommen</translation>
    </message>
    <message>
        <source>What does your tool weigh?</source>
        <translation>Was wiegt Ihr Werkzeug?</translation>
    </message>
    <message>
        <source>Open a recording of the arm moving with its tool. Heft finds mass, centre of mass and inertia, and tells how sure each number is.</source>
        <translation>Öffnen Sie eine Aufnahme, in der sich der Arm mit seinem Werkzeug bewegt. Heft findet Masse, Schwerpunkt und Trägheit und sagt, wie sicher jeder Wert ist.</translation>
    </message>
    <message>
        <source>What a recording holds</source>
        <translation>Was eine Aufnahme enthält</translation>
    </message>
    <message>
        <source>You can also drop a file anywhere in this window.</source>
        <translation>Sie können eine Datei auch irgendwo in dieses Fenster ziehen.</translation>
    </message>
    <message>
        <source>Open another …</source>
        <translation>Weitere öffnen …</translation>
    </message>
    <message>
        <source>See the result</source>
        <translation>Ergebnis ansehen</translation>
    </message>
    <message>
        <source>Open a recording …</source>
        <translation>Aufnahme öffnen …</translation>
    </message>
    <message>
        <source>Opened lately</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>In this session</source>
        <translation>In dieser Sitzung</translation>
    </message>
    <message>
        <source>%1, not read</source>
        <translation>%1, nicht gelesen</translation>
    </message>
    <message>
        <source>%1, %2 kg</source>
        <translation>%1, %2 kg</translation>
    </message>
    <message>
        <source>Shown now: %1</source>
        <translation>Jetzt gezeigt: %1</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Time, joint angles or sensor poses, and force and torque: a CSV, a ROS bag, MCAP or HDF5. A file NAME.meta.json beside it may name the robot and how the sensor is mounted.</source>
        <translation>Zeit, Gelenkwinkel oder Sensorposen, Kraft und Moment: als CSV, ROS-Bag, MCAP oder HDF5. Eine Datei NAME.meta.json daneben kann den Roboter nennen und wie der Sensor angebaut ist.</translation>
    </message>
</context>
<context>
    <name>heft::RecordingPane</name>
    <message>
        <source>Force and torque at the sensor</source>
        <translation>Kraft und Moment am Sensor</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simuliert</translation>
    </message>
    <message>
        <source>difference, grey = noise</source>
        <translation>Differenz, grau = Rauschen</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Drag over the plots to mark a stretch, instead of zooming</source>
        <translation>Ziehen über die Kurven markiert einen Abschnitt, statt zu vergrößern</translation>
    </message>
    <message>
        <source>Show the whole recording (0)</source>
        <translation>Die ganze Aufnahme zeigen (0)</translation>
    </message>
    <message>
        <source>Save a picture of the plots</source>
        <translation>Bild der Kurven speichern</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Show force and torque</source>
        <translation>Kraft und Moment zeigen</translation>
    </message>
    <message>
        <source>Measure between two cursors (Ctrl+click puts the second one)</source>
        <translation>Zwischen zwei Linien messen (Strg+Klick setzt die zweite)</translation>
    </message>
    <message>
        <source>Save the visible stretch as CSV</source>
        <translation>Sichtbaren Abschnitt als CSV speichern</translation>
    </message>
</context>
<context>
    <name>heft::ResultPanel</name>
    <message>
        <source>measured, check first</source>
        <translation>gemessen, erst prüfen</translation>
    </message>
    <message>
        <source>What does your tool weigh?</source>
        <translation>Was wiegt Ihr Werkzeug?</translation>
    </message>
    <message>
        <source>Open a recording first, or make one under Record.</source>
        <translation>Öffnen Sie zuerst eine Aufnahme, oder machen Sie eine unter Aufnehmen.</translation>
    </message>
    <message>
        <source>Weighing the tool …</source>
        <translation>Das Werkzeug wird gewogen …</translation>
    </message>
    <message>
        <source>Heft reads the motion and the forces in %1.</source>
        <translation>Heft liest Bewegung und Kräfte in %1.</translation>
    </message>
    <message>
        <source>No estimate yet</source>
        <translation>Noch keine Schätzung</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>Schätzen</translation>
    </message>
    <message>
        <source>One more note under Details.</source>
        <translation>Noch ein Hinweis unter Details.</translation>
    </message>
    <message>
        <source>%1 more notes under Details.</source>
        <translation>Noch %1 Hinweise unter Details.</translation>
    </message>
    <message>
        <source>Export these numbers</source>
        <translation>Werte ausgeben</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Centre of mass</source>
        <translation>Schwerpunkt</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>From the sensor’s origin, along its axes.</source>
        <translation>Vom Ursprung des Sensors, entlang seiner Achsen.</translation>
    </message>
    <message>
        <source>Inertia</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>about the centre, %1</source>
        <translation>um den Schwerpunkt, %1</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>All methods</source>
        <translation>Alle Verfahren</translation>
    </message>
    <message>
        <source>What would make it better</source>
        <translation>Was es besser machen würde</translation>
    </message>
    <message>
        <source>Record it</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Where the numbers come from</source>
        <translation>Woher die Werte kommen</translation>
    </message>
    <message>
        <source>Compared with what you know</source>
        <translation>Verglichen mit dem, was Sie wissen</translation>
    </message>
    <message>
        <source>Compare with a scale or CAD …</source>
        <translation>Mit Waage oder CAD vergleichen …</translation>
    </message>
    <message>
        <source>Change what you know …</source>
        <translation>Ändern, was Sie wissen …</translation>
    </message>
</context>
<context>
    <name>heft::ResultStep</name>
    <message>
        <source>after recording</source>
        <translation>nach der Aufnahme</translation>
    </message>
    <message>
        <source>being weighed …</source>
        <translation>wird gewogen …</translation>
    </message>
    <message>
        <source>no estimate yet</source>
        <translation>noch keine Schätzung</translation>
    </message>
    <message>
        <source>%1 kg</source>
        <translation>%1 kg</translation>
    </message>
    <message>
        <source>%1, check first</source>
        <translation>%1, erst prüfen</translation>
    </message>
    <message>
        <source>mass not known</source>
        <translation>Masse nicht bekannt</translation>
    </message>
    <message>
        <source>The estimate was stopped.</source>
        <translation>Die Schätzung wurde angehalten.</translation>
    </message>
    <message>
        <source>known values</source>
        <translation>bekannte Werte</translation>
    </message>
    <message>
        <source>Comparing all methods</source>
        <translation>Alle Verfahren werden verglichen</translation>
    </message>
    <message>
        <source>All &amp;methods side by side</source>
        <translation>Alle &amp;Verfahren nebeneinander</translation>
    </message>
    <message>
        <source>Compare with a scale or &amp;CAD …</source>
        <translation>Mit Waage oder &amp;CAD vergleichen …</translation>
    </message>
    <message>
        <source>compare needs an open recording.</source>
        <translation>compare braucht eine offene Aufnahme.</translation>
    </message>
</context>
<context>
    <name>heft::RobotView</name>
    <message>
        <source>3D view of robot and tool</source>
        <translation>3D-Ansicht von Roboter und Werkzeug</translation>
    </message>
    <message>
        <source>Arrow keys turn the view, with Shift they move it, plus and minus zoom</source>
        <translation>Pfeiltasten drehen die Ansicht, mit Umschalt verschieben sie, Plus und Minus vergrößern und verkleinern</translation>
    </message>
    <message>
        <source>Show the whole arm (F)</source>
        <translation>Den ganzen Arm zeigen (F)</translation>
    </message>
    <message>
        <source>Go close to the tool (T)</source>
        <translation>Nah ans Werkzeug gehen (T)</translation>
    </message>
    <message>
        <source>Look from another side</source>
        <translation>Von einer anderen Seite ansehen</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Choose what is shown</source>
        <translation>Wählen, was gezeigt wird</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Force, torque and gravity</source>
        <translation>Kraft, Moment und Schwerkraft</translation>
    </message>
    <message>
        <source>Sensor axes</source>
        <translation>Sensorachsen</translation>
    </message>
    <message>
        <source>Centre of mass</source>
        <translation>Schwerpunkt</translation>
    </message>
    <message>
        <source>Floor grid</source>
        <translation>Bodengitter</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Beschriftungen</translation>
    </message>
    <message>
        <source>Save a picture of this view</source>
        <translation>Bild dieser Ansicht speichern</translation>
    </message>
    <message>
        <source>force and torque</source>
        <translation>Kraft und Moment</translation>
    </message>
    <message>
        <source>95 % region, drawn %1× larger</source>
        <translation>95-%-Bereich, %1× vergrößert</translation>
    </message>
    <message>
        <source>95 % region</source>
        <translation>95-%-Bereich</translation>
    </message>
    <message>
        <source>known to better than 0.2 mm</source>
        <translation>auf besser als 0,2 mm bekannt</translation>
    </message>
    <message>
        <source>equal-inertia box</source>
        <translation>Quader gleicher Trägheit</translation>
    </message>
    <message>
        <source>gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>This recording has no robot: the sensor is shown alone</source>
        <translation>Diese Aufnahme hat keinen Roboter: Nur der Sensor wird gezeigt</translation>
    </message>
    <message>
        <source>This recording has no position: the sensor turns in place</source>
        <translation>Diese Aufnahme hat keine Position: Der Sensor dreht sich auf der Stelle</translation>
    </message>
</context>
<context>
    <name>heft::ScriptRunner</name>
    <message>
        <source>picture expects a file and perhaps window, view, plots or panel.</source>
        <translation>picture erwartet eine Datei und vielleicht window, view, plots oder panel.</translation>
    </message>
    <message>
        <source>%1 could not be written: check that the folder exists, may be written to, and that the name ends in .png.</source>
        <translation>%1 konnte nicht geschrieben werden: Prüfen Sie, ob es den Ordner gibt, ob man in ihn schreiben darf und ob der Name auf .png endet.</translation>
    </message>
    <message>
        <source>There is no step %1.</source>
        <translation>Es gibt keinen Schritt %1.</translation>
    </message>
    <message>
        <source>estimate needs an open recording.</source>
        <translation>estimate braucht eine offene Aufnahme.</translation>
    </message>
    <message>
        <source>%1 exists already and was not replaced.</source>
        <translation>%1 gibt es schon und wurde nicht ersetzt.</translation>
    </message>
    <message>
        <source>camera expects whole, tool, front, side or top.</source>
        <translation>camera erwartet whole, tool, front, side oder top.</translation>
    </message>
    <message>
        <source>language expects one of %1.</source>
        <translation>language erwartet eine von %1.</translation>
    </message>
    <message>
        <source>size expects WIDTHxHEIGHT between 640x400 and 7680x4320.</source>
        <translation>size erwartet BREITExHÖHE zwischen 640x400 und 7680x4320.</translation>
    </message>
    <message>
        <source>There is no button %1 that could be clicked now.</source>
        <translation>Es gibt keinen Knopf %1, der jetzt gedrückt werden könnte.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no command of a script, or its words are wrong; see heft-studio --help.</source>
        <translation>„%1“ ist kein Befehl eines Skripts, oder seine Wörter stimmen nicht; siehe heft-studio --help.</translation>
    </message>
</context>
<context>
    <name>heft::StatusBar</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Stop this</source>
        <translation>Das anhalten</translation>
    </message>
</context>
<context>
    <name>heft::StepBar</name>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
</context>
<context>
    <name>heft::StepButton</name>
    <message>
        <source>shown now</source>
        <translation>jetzt gezeigt</translation>
    </message>
    <message>
        <source>next</source>
        <translation>als Nächstes</translation>
    </message>
    <message>
        <source>later</source>
        <translation>später</translation>
    </message>
    <message>
        <source>Step %1, %2</source>
        <translation>Schritt %1, %2</translation>
    </message>
    <message>
        <source>%1 (Alt+%2)</source>
        <translation>%1 (Alt+%2)</translation>
    </message>
</context>
<context>
    <name>heft::Workspace</name>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Marked in the file.</source>
        <translation>In der Datei markiert.</translation>
    </message>
    <message>
        <source>Marked by you.</source>
        <translation>Von Ihnen markiert.</translation>
    </message>
    <message>
        <source>Estimating</source>
        <translation>Schätzen</translation>
    </message>
    <message>
        <source>take back a mark</source>
        <translation>Marke zurücknehmen</translation>
    </message>
    <message>
        <source>mark as free</source>
        <translation>als frei markieren</translation>
    </message>
    <message>
        <source>mark as contact</source>
        <translation>als Kontakt markieren</translation>
    </message>
    <message>
        <source>mark as ignored</source>
        <translation>als ignoriert markieren</translation>
    </message>
</context>
<context>
    <name>heft::WrenchPlots</name>
    <message>
        <source>Force and torque plots</source>
        <translation>Kurven von Kraft und Moment</translation>
    </message>
    <message>
        <source>Measured, simulated and difference over time. Arrow keys move the time, plus and minus zoom.</source>
        <translation>Gemessen, simuliert und Differenz über der Zeit. Pfeiltasten bewegen die Zeit, Plus und Minus vergrößern und verkleinern.</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Moment</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>N m</source>
        <translation>N m</translation>
    </message>
</context>
</TS>
