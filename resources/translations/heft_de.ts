<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>CauseCard</name>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>after</source>
        <translation>nachher</translation>
    </message>
    <message>
        <source>Measured, old and improved simulation on the held-out segment</source>
        <translation>Gemessen, alte und verbesserte Simulation auf dem ungesehenen Abschnitt</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>%1 to %2 s</source>
        <translation>%1 bis %2 s</translation>
    </message>
    <message>
        <source>Evidence (ΔBIC)</source>
        <translation>Beweiskraft (ΔBIC)</translation>
    </message>
    <message>
        <source>How much better the recording is explained, after paying for the extra numbers; under %1 nothing is named.</source>
        <translation>Wie viel besser die Aufnahme erklärt wird, nach Abzug für die zusätzlichen Zahlen; unter %1 wird nichts benannt.</translation>
    </message>
    <message>
        <source>p-value</source>
        <translation>p-Wert</translation>
    </message>
    <message>
        <source>How often a clean recording with this motion and noise looks at least as conspicuous</source>
        <translation>Wie oft eine saubere Aufnahme mit dieser Bewegung und diesem Rauschen mindestens so auffällig aussieht</translation>
    </message>
    <message>
        <source>Better on</source>
        <translation>Besser auf</translation>
    </message>
    <message>
        <source>%1 of %2 held-out segments</source>
        <translation>%1 von %2 ungesehenen Abschnitten</translation>
    </message>
    <message>
        <source>%1 % (95 %: %2 to %3 %)</source>
        <translation>%1 % (95 %: %2 bis %3 %)</translation>
    </message>
    <message>
        <source>Share of the squared error that goes away on held-out segments</source>
        <translation>Anteil des quadrierten Fehlers, der auf ungesehenen Abschnitten verschwindet</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Drehmoment</translation>
    </message>
    <message>
        <source>Applied</source>
        <translation>Angewandt</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Apply this correction</source>
        <translation>Berichtigung anwenden</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>The cause becomes part of the model: result, prediction and export use it</source>
        <translation>Die Ursache wird Teil des Modells: Ergebnis, Vorhersage und Ausgabe benutzen sie</translation>
    </message>
    <message>
        <source>Already compensated; fix it on the robot.</source>
        <translation>Heft berücksichtigt es bereits; abgestellt wird es am Aufbau.</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>seen directly</source>
        <translation>direkt gesehen</translation>
    </message>
    <message>
        <source>The readings themselves show it.</source>
        <translation>Die Messwerte selbst zeigen es.</translation>
    </message>
    <message numerus="yes">
        <source>%n false alarm(s) in %1 simulated clean runs.</source>
        <translation>
            <numerusform>%n Fehlalarm in %1 simulierten sauberen Läufen.</numerusform>
            <numerusform>%n Fehlalarme in %1 simulierten sauberen Läufen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>old model</source>
        <translation>altes Modell</translation>
    </message>
    <message>
        <source>improved</source>
        <translation>verbessert</translation>
    </message>
    <message>
        <source>Cause found</source>
        <translation>Ursache gefunden</translation>
    </message>
    <message>
        <source>The model was fitted without this segment. Grey: twice the sensor’s noise.</source>
        <translation>Das Modell wurde ohne diesen Abschnitt angepasst. Grau: das doppelte Rauschen des Sensors.</translation>
    </message>
    <message>
        <source>Check on the robot:</source>
        <translation>Am Aufbau prüfen:</translation>
    </message>
    <message>
        <source>Two causes possible</source>
        <translation>Zwei Ursachen möglich</translation>
    </message>
    <message>
        <source>Several causes possible</source>
        <translation>Mehrere Ursachen möglich</translation>
    </message>
    <message>
        <source>not determined by this motion</source>
        <translation>diese Bewegung verrät es nicht</translation>
    </message>
    <message>
        <source>or</source>
        <translation>oder</translation>
    </message>
    <message>
        <source>To decide:</source>
        <translation>Zum Entscheiden:</translation>
    </message>
    <message>
        <source>Record this motion</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Something unknown</source>
        <translation>Etwas Unbekanntes</translation>
    </message>
    <message>
        <source>shown, not named</source>
        <translation>gezeigt, nicht benannt</translation>
    </message>
    <message>
        <source>The remaining error is related to %1.</source>
        <translation>Es bleibt etwas, das mit %1 zusammenhängt.</translation>
    </message>
    <message>
        <source>Frequency [Hz]</source>
        <translation>Frequenz [Hz]</translation>
    </message>
    <message>
        <source> Most of it lies at %1 Hz.</source>
        <translation> Das meiste liegt bei %1 Hz.</translation>
    </message>
    <message>
        <source>What helps:</source>
        <translation>Was hilft:</translation>
    </message>
    <message>
        <source>record the same motion once more, without touching anything, and compare.</source>
        <translation>dieselbe Bewegung noch einmal aufnehmen, ohne etwas zu berühren, und vergleichen.</translation>
    </message>
    <message>
        <source>Model fits</source>
        <translation>Modell passt</translation>
    </message>
    <message>
        <source>The remaining error is sensor noise.</source>
        <translation>Es bleibt nur das Rauschen des Sensors.</translation>
    </message>
    <message>
        <source>Show the motion</source>
        <translation>Bewegung zeigen</translation>
    </message>
    <message>
        <source>Error in %1 [%2]</source>
        <translation>Fehler: %1 [%2]</translation>
    </message>
    <message>
        <source>Value and half of its 95 % interval; in files: %1</source>
        <translation>Wert und halber 95-%-Bereich; in Dateien: %1</translation>
    </message>
    <message>
        <source>Forces fit less well with it there: %1 → %2.</source>
        <translation>Die Kräfte passen dort damit schlechter: %1 → %2.</translation>
    </message>
    <message>
        <source>These segments are already excluded (see Mark).</source>
        <translation>Diese Abschnitte sind schon ausgelassen; der Schritt Markieren zeigt sie.</translation>
    </message>
    <message>
        <source> Most of it lies between %1 and %2 Hz.</source>
        <translation> Das meiste davon liegt zwischen %1 und %2 Hz.</translation>
    </message>
    <message>
        <source>very strong evidence</source>
        <translation>sehr starke Belege</translation>
    </message>
    <message>
        <source>strong evidence</source>
        <translation>starke Belege</translation>
    </message>
    <message>
        <source>weak evidence</source>
        <translation>schwache Belege</translation>
    </message>
    <message>
        <source>large effect</source>
        <translation>große Wirkung</translation>
    </message>
    <message>
        <source>moderate effect</source>
        <translation>mittlere Wirkung</translation>
    </message>
    <message>
        <source>small effect</source>
        <translation>kleine Wirkung</translation>
    </message>
    <message>
        <source>I%1%2 %3 → %4 kg cm²</source>
        <translation>I%1%2 %3 → %4 kg cm²</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Explains a part</source>
        <translation>Erklärt einen Teil</translation>
    </message>
    <message>
        <source>Show it below the arm</source>
        <translation>Unter dem Arm zeigen</translation>
    </message>
    <message>
        <source>Measured and simulated, without and with this cause, where it shows best</source>
        <translation>Gemessen und simuliert, ohne und mit dieser Ursache, wo man sie am besten sieht</translation>
    </message>
    <message>
        <source>Torques fit less well with it there: %1 → %2.</source>
        <translation>Die Drehmomente passen dort damit schlechter: %1 → %2.</translation>
    </message>
    <message>
        <source>mass %1 → %2</source>
        <translation>Masse %1 → %2</translation>
    </message>
    <message>
        <source>centre %1 %2 → %3</source>
        <translation>Schwerpunkt %1 %2 → %3</translation>
    </message>
    <message>
        <source>mass ± %1 → ± %2</source>
        <translation>Masse ± %1 → ± %2</translation>
    </message>
    <message>
        <source>Error %1, noise floor %2; torque %3.</source>
        <translation>Fehler %1, Rauschen %2; Drehmoment %3.</translation>
    </message>
    <message>
        <source>Held-out error %1 before, %2 after, noise floor %3</source>
        <translation>Ungesehener Fehler %1 vorher, %2 nachher, Rauschen %3</translation>
    </message>
    <message>
        <source>Root mean square of the residual on segments that were not used for fitting.</source>
        <translation>Effektivwert des Rests auf Abschnitten, die nicht zur Anpassung dienten.</translation>
    </message>
    <message>
        <source>Variance explained</source>
        <translation>Erklärte Varianz</translation>
    </message>
    <message>
        <source>ID in files</source>
        <translation>Kennung in Dateien</translation>
    </message>
    <message>
        <source>Estimates the payload again, without this correction</source>
        <translation>Schätzt die Last wieder ohne diese Berichtigung</translation>
    </message>
    <message>
        <source>Far above what noise alone would produce.</source>
        <translation>Weit über dem, was Rauschen allein ergäbe.</translation>
    </message>
    <message>
        <source>Error on a held-out segment, before and after</source>
        <translation>Fehler auf einem ungesehenen Abschnitt, vorher und nachher</translation>
    </message>
    <message>
        <source>Held-out error %1 → %2; dashed: noise floor %3.</source>
        <translation>Ungesehener Fehler %1 → %2; gestrichelt: Rauschen %3.</translation>
    </message>
    <message>
        <source>Either way: held-out error %1 → %2; noise floor %3.</source>
        <translation>Welche es auch ist: ungesehener Fehler %1 → %2; Rauschen %3.</translation>
    </message>
    <message>
        <source>Residual spectrum [N/√Hz]</source>
        <translation>Spektrum des Rests [N/√Hz]</translation>
    </message>
    <message>
        <source>Grey: the level of the sensor’s fast noise. What rises far above it is unexplained.</source>
        <translation>Grau: die Höhe des schnellen Sensorrauschens. Was weit darüber ragt, ist unerklärt.</translation>
    </message>
    <message>
        <source>It accounts for %1 % of the residual.</source>
        <translation>Es macht %1 % des Rests aus.</translation>
    </message>
    <message>
        <source> No known cause explains it, so Heft neither names nor corrects it.</source>
        <translation> Keine bekannte Ursache erklärt es; deshalb benennt und berichtigt Heft es nicht.</translation>
    </message>
    <message>
        <source>The arm’s ghost shows the motion in the 3D view</source>
        <translation>Der Schatten des Arms zeigt die Bewegung in der 3D-Ansicht</translation>
    </message>
    <message>
        <source>Goes to Record; the instruction stays visible there</source>
        <translation>Führt zum Aufnehmen; was zu tun ist, bleibt dort im Blick</translation>
    </message>
    <message>
        <source>It fits this recording but does not improve held-out segments. Apply it only if a check on the robot confirms it.</source>
        <translation>Es passt zu dieser Aufnahme, verbessert ungesehene Abschnitte aber nicht. Wenden Sie es nur an, wenn eine Prüfung am Roboter es bestätigt.</translation>
    </message>
    <message>
        <source>The residual is %1 times the noise: something else contributes, or is the real cause.</source>
        <translation>Der Rest ist das %1-Fache des Rauschens: Etwas anderes wirkt mit oder ist die wahre Ursache.</translation>
    </message>
    <message>
        <source>“Apply” corrects the first one, “%1”, which fits slightly better.</source>
        <translation>„Anwenden“ berichtigt die erste, „%1“, die etwas besser passt.</translation>
    </message>
</context>
<context>
    <name>CauseMarks</name>
    <message>
        <source>%1, drawn %2× larger</source>
        <translation>%1, %2× größer gezeichnet</translation>
    </message>
    <message>
        <source>Something touched the tool</source>
        <translation>Etwas hat das Werkzeug berührt</translation>
    </message>
    <message>
        <source>%1 N at %2 s</source>
        <translation>%1 N bei %2 s</translation>
    </message>
    <message>
        <source>The sensor’s true axes</source>
        <translation>Wahre Achsen des Sensors</translation>
    </message>
    <message>
        <source>rotated by %1°</source>
        <translation>um %1° verdreht</translation>
    </message>
    <message>
        <source>The sensor’s true origin</source>
        <translation>Wahrer Ursprung des Sensors</translation>
    </message>
    <message>
        <source>%1 mm away</source>
        <translation>%1 mm entfernt</translation>
    </message>
    <message>
        <source>True gravity</source>
        <translation>Wahre Schwerkraft</translation>
    </message>
    <message>
        <source>base tilted by %1°</source>
        <translation>Sockel um %1° gekippt</translation>
    </message>
    <message>
        <source>A steady pull</source>
        <translation>Ein stetiger Zug</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>The load became heavier</source>
        <translation>Die Last wurde schwerer</translation>
    </message>
    <message>
        <source>The load became lighter</source>
        <translation>Die Last wurde leichter</translation>
    </message>
    <message>
        <source>%1 g from %2 s on</source>
        <translation>%1 g ab %2 s</translation>
    </message>
    <message>
        <source>Something loose swings</source>
        <translation>Etwas Loses schwingt</translation>
    </message>
    <message>
        <source>%1 g at %2 Hz</source>
        <translation>%1 g mit %2 Hz</translation>
    </message>
</context>
<context>
    <name>Channels</name>
    <message>
        <source>Joint angles</source>
        <translation>Gelenkwinkel</translation>
    </message>
    <message>
        <source>Joint speeds</source>
        <translation>Gelenkgeschwindigkeiten</translation>
    </message>
    <message>
        <source>Joint speeds, from the angles</source>
        <translation>Gelenkgeschwindigkeiten, aus den Winkeln</translation>
    </message>
    <message>
        <source>Sensor position</source>
        <translation>Lage des Sensors</translation>
    </message>
    <message>
        <source>Sensor orientation</source>
        <translation>Drehung des Sensors</translation>
    </message>
    <message>
        <source>Other columns of the file</source>
        <translation>Andere Spalten der Datei</translation>
    </message>
    <message>
        <source>Speeds and magnitudes</source>
        <translation>Geschwindigkeiten und Beträge</translation>
    </message>
</context>
<context>
    <name>Entry</name>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 N m</source>
        <translation>%1 N m</translation>
    </message>
    <message>
        <source>A push along it stops the arm at %1 instead of %2, a push against it only at %3.</source>
        <translation>Ein Stoß in ihrer Richtung hält den Arm bei %1 statt bei %2 an, ein Stoß gegen sie erst bei %3.</translation>
    </message>
    <message>
        <source>Weight: set, estimated</source>
        <translation>Gewicht: eingestellt, geschätzt</translation>
    </message>
    <message>
        <source>Everything beyond the flange: the tool, and what you listed under Export as mounted</source>
        <translation>Alles jenseits des Flanschs: das Werkzeug und was laut „Ausgeben“ außerdem angebaut ist</translation>
    </message>
    <message>
        <source>Distance between the two centres of mass</source>
        <translation>Abstand der beiden Schwerpunkte</translation>
    </message>
    <message>
        <source>Phantom force</source>
        <translation>Scheinkraft</translation>
    </message>
    <message>
        <source>The entry agrees with this recording.</source>
        <translation>Der Eintrag stimmt, soweit diese Aufnahme es sagen kann.</translation>
    </message>
    <message>
        <source>The differences are within the intervals of the estimate.</source>
        <translation>Was abweicht, liegt innerhalb der Bereiche der Schätzung.</translation>
    </message>
    <message>
        <source>The controller sees up to %1 N m of phantom torque.</source>
        <translation>Die Steuerung spürt bis zu %1 N m, die niemand ausübt.</translation>
    </message>
    <message>
        <source>The controller sees a phantom force of up to %1.</source>
        <translation>Die Steuerung spürt bis zu %1, die niemand ausübt.</translation>
    </message>
    <message>
        <source>That is more than the collision threshold of %1: the arm stops although nothing touches it.</source>
        <translation>Das ist mehr als die Kollisionsschwelle von %1: Der Arm hält an, obwohl ihn nichts berührt.</translation>
    </message>
    <message>
        <source>No centre of mass is set, so the estimated one is used.</source>
        <translation>Ein Schwerpunkt ist nicht eingestellt, daher gilt der geschätzte.</translation>
    </message>
    <message>
        <source>No inertia is set, so the estimated one is used.</source>
        <translation>Eine Trägheit ist nicht eingestellt, daher gilt die geschätzte.</translation>
    </message>
    <message>
        <source>No centre of mass and no inertia are set, so the estimated ones are used.</source>
        <translation>Schwerpunkt und Trägheit sind nicht eingestellt, daher gelten die geschätzten.</translation>
    </message>
    <message>
        <source>With a stiffness of %1 N/m it sinks by %2 when it stands still.</source>
        <translation>Bei einer Steifigkeit von %1 N/m sinkt er im Stand um %2.</translation>
    </message>
    <message>
        <source>With a stiffness of %1 N/m it rises by %2 when it stands still.</source>
        <translation>Bei einer Steifigkeit von %1 N/m steigt er im Stand um %2.</translation>
    </message>
    <message>
        <source>%1 N, %2 of the limit</source>
        <translation>%1 N, %2 der Grenze</translation>
    </message>
    <message>
        <source>For 99 % of this motion it is not larger. The limit is the collision threshold.</source>
        <translation>In 99 % dieser Bewegung ist sie nicht größer. Die Grenze ist die Kollisionsschwelle.</translation>
    </message>
    <message>
        <source>Phantom torque</source>
        <translation>Scheinmoment</translation>
    </message>
    <message>
        <source>%1 %2, %3 of the limit</source>
        <translation>%1 %2, %3 der Grenze</translation>
    </message>
    <message>
        <source>About the flange; for 99 % of this motion it is not larger. The limit is the collision threshold.</source>
        <translation>Um den Flansch; in 99 % dieser Bewegung ist es nicht größer. Die Grenze ist die Kollisionsschwelle.</translation>
    </message>
    <message>
        <source>Centre off by</source>
        <translation>Schwerpunkt daneben um</translation>
    </message>
</context>
<context>
    <name>ExportText</name>
    <message>
        <source>Franka profile</source>
        <translation>Franka-Profil</translation>
    </message>
    <message>
        <source>link with inertia</source>
        <translation>Glied mit Trägheit</translation>
    </message>
    <message>
        <source>Gazebo model</source>
        <translation>Gazebo-Modell</translation>
    </message>
    <message>
        <source>payload schedule</source>
        <translation>Payload-Tabelle</translation>
    </message>
    <message>
        <source>for programs</source>
        <translation>für Programme</translation>
    </message>
    <message>
        <source>This file sets the load on top of the end effector. Enter the robot’s own tool in Franka Desk instead; otherwise its weight counts twice.</source>
        <translation>Diese Datei setzt die Last zusätzlich zum Endeffektor. Das eigene Werkzeug des Roboters gehört in Franka Desk; an beiden Stellen angegeben, zählt sein Gewicht doppelt.</translation>
    </message>
    <message>
        <source>This file describes the robot’s own end effector. Something that it picked up belongs into setLoad (libfranka or ROS), added to the tool that is already there.</source>
        <translation>Diese Datei beschreibt den eigenen Endeffektor des Roboters. Was er aufgenommen hat, gehört in setLoad (libfranka oder ROS), zusätzlich zum Werkzeug, das schon da ist.</translation>
    </message>
    <message>
        <source>UR expects tool and load combined: tick the tool under “What else is mounted?”.</source>
        <translation>Ein UR will Werkzeug und Last zusammen in einer Zahl: Haken Sie das Werkzeug unter „Was ist noch angebaut?“ an.</translation>
    </message>
    <message>
        <source>The mass is not known from this motion.</source>
        <translation>Die Masse ist aus dieser Bewegung nicht bekannt.</translation>
    </message>
    <message>
        <source>Physically consistent.</source>
        <translation>Ein wirklicher Körper kann diese Werte haben.</translation>
    </message>
    <message>
        <source>end effector</source>
        <translation>Endeffektor</translation>
    </message>
    <message>
        <source>body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>gravity compensation</source>
        <translation>Schwerkraftausgleich</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>The inertia is not known from this motion; the file contains only a plausible value. Fine for slow work; record faster rotations for fast work.</source>
        <translation>Die Trägheit ist aus dieser Bewegung nicht bekannt; die Datei enthält nur einen plausiblen Wert. Gut für langsame Arbeit; nehmen Sie für schnelle Arbeit schnellere Drehungen auf.</translation>
    </message>
    <message>
        <source>The inertia comes from your shape, not from your motion. Fine for slow work; record faster rotations for fast work.</source>
        <translation>Die Trägheit kommt aus Ihrer Form, nicht aus der Bewegung. Gut für langsame Arbeit; nehmen Sie für schnelle Arbeit schnellere Drehungen auf.</translation>
    </message>
    <message>
        <source>Well below the arm’s payload limit of %1 kg.</source>
        <translation>Deutlich unter der Traglast des Arms von %1 kg.</translation>
    </message>
    <message>
        <source>You chose to write numbers that the recording does not support. %1</source>
        <translation>Sie wollten Zahlen schreiben, die nichts in der Aufnahme stützt. %1</translation>
    </message>
    <message>
        <source>The tool centre point is written at the flange, and loading the file sets the controller’s TCP there. Enter it above if it is elsewhere.</source>
        <translation>Der Werkzeugmittelpunkt steht am Flansch. Beim Laden setzt die Steuerung ihren TCP dorthin: Liegt er woanders, geben Sie ihn oben an.</translation>
    </message>
</context>
<context>
    <name>FileDialogLook</name>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>%1 file</source>
        <translation>%1-Datei</translation>
    </message>
</context>
<context>
    <name>GapMark</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Too near: %1</source>
        <translation>Zu nah: %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
</context>
<context>
    <name>Glossary</name>
    <message>
        <source>Plain words</source>
        <translation>Einfach gesagt</translation>
    </message>
    <message>
        <source>In the field</source>
        <translation>Im Fach</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Was es ist</translation>
    </message>
</context>
<context>
    <name>Joining</name>
    <message>
        <source>Look at its result alone, or leave it out.</source>
        <translation>Sehen Sie sich ihr eigenes Ergebnis an, oder lassen Sie sie weg.</translation>
    </message>
    <message>
        <source>%1 is not reliable, so neither are the numbers from all of them.</source>
        <translation>%1 ist nicht verlässlich, und damit auch nicht die Werte aus allen zusammen.</translation>
    </message>
    <message numerus="yes">
        <source>Joint result from %n recordings: %1.</source>
        <translation>
            <numerusform>Gemeinsames Ergebnis aus %n Aufnahme: %1.</numerusform>
            <numerusform>Gemeinsames Ergebnis aus %n Aufnahmen: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>This recording contradicts the others, or Heft cannot explain it. It keeps its own numbers.</source>
        <translation>Diese Aufnahme widerspricht den anderen, oder Heft kann sie nicht erklären. Sie behält ihre eigenen Werte.</translation>
    </message>
    <message>
        <source>Only recordings without applied corrections are joined; these numbers come from %1 alone.</source>
        <translation>Zusammengefasst werden nur Aufnahmen ohne angewandte Korrekturen; diese Werte stammen allein aus %1.</translation>
    </message>
</context>
<context>
    <name>LiveWords</name>
    <message>
        <source>Tilt the tool sideways and back, slowly</source>
        <translation>Neigen Sie das Werkzeug langsam zur Seite und zurück</translation>
    </message>
    <message>
        <source>tilt sideways, slowly</source>
        <translation>langsam zur Seite neigen</translation>
    </message>
    <message>
        <source>Tilt the tool forwards and back, slowly</source>
        <translation>Neigen Sie das Werkzeug langsam nach vorn und zurück</translation>
    </message>
    <message>
        <source>tilt forwards, slowly</source>
        <translation>langsam nach vorn neigen</translation>
    </message>
    <message>
        <source>Move the tool in a slow circle, as if stirring</source>
        <translation>Neigen Sie das Werkzeug langsam im Kreis, wie beim Umrühren</translation>
    </message>
    <message>
        <source>tilt in a slow circle</source>
        <translation>langsam im Kreis neigen</translation>
    </message>
    <message>
        <source>Rotate the tool slowly about its long axis, as far as it goes</source>
        <translation>Drehen Sie das Werkzeug langsam und weit um seine Längsachse</translation>
    </message>
    <message>
        <source>turn far, slowly</source>
        <translation>langsam und weit drehen</translation>
    </message>
    <message>
        <source>Rotate the tool back and forth about its long axis, faster</source>
        <translation>Drehen Sie das Werkzeug schneller um seine Längsachse hin und her</translation>
    </message>
    <message>
        <source>swing sideways</source>
        <translation>seitlich schwenken</translation>
    </message>
    <message>
        <source>swing forwards</source>
        <translation>vor und zurück schwenken</translation>
    </message>
    <message>
        <source>swing in a circle</source>
        <translation>im Kreis schwenken</translation>
    </message>
    <message>
        <source>shake sideways</source>
        <translation>seitlich schütteln</translation>
    </message>
    <message>
        <source>shake forwards</source>
        <translation>vor und zurück schütteln</translation>
    </message>
    <message>
        <source>shake about its axis</source>
        <translation>um die Längsachse schütteln</translation>
    </message>
    <message>
        <source>± %1 g</source>
        <translation>± %1 g</translation>
    </message>
    <message>
        <source>± %1 kg</source>
        <translation>± %1 kg</translation>
    </message>
    <message>
        <source>± %1 mm</source>
        <translation>± %1 mm</translation>
    </message>
    <message>
        <source>over ± 999 %</source>
        <translation>über ± 999 %</translation>
    </message>
    <message>
        <source>± %1 %</source>
        <translation>± %1 %</translation>
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
        <source>Inertia</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>%1 %2 → %3</source>
        <translation>%1 %2 → %3</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Gut</translation>
    </message>
    <message>
        <source>From your shape</source>
        <translation>Aus Ihrer Form</translation>
    </message>
    <message>
        <source>Nearly there</source>
        <translation>Fast so weit</translation>
    </message>
    <message>
        <source>used</source>
        <translation>benutzt</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>bewegt</translation>
    </message>
    <message>
        <source>touched</source>
        <translation>berührt</translation>
    </message>
    <message>
        <source>Used.</source>
        <translation>Benutzt.</translation>
    </message>
    <message>
        <source>Too similar to an earlier pose. Tilt the tool further.</source>
        <translation>Das Werkzeug hängt fast wie in einer anderen Haltung: Neigen Sie es weiter.</translation>
    </message>
    <message>
        <source>The tool moved: hold it still for a second.</source>
        <translation>Das Werkzeug hat sich bewegt: Halten Sie es eine Sekunde still.</translation>
    </message>
    <message>
        <source>The force differs by %1 N from the other poses: something touched the tool.</source>
        <translation>Die Kraft weicht um %1 N von dem ab, was die anderen Haltungen sagen: Etwas hat das Werkzeug berührt.</translation>
    </message>
    <message>
        <source>The tilts cover all directions.</source>
        <translation>Die Neigungen decken alle Richtungen ab.</translation>
    </message>
    <message numerus="yes">
        <source>%n of at least 6 poses can be used.</source>
        <translation>
            <numerusform>%n von mindestens 6 Haltungen ist brauchbar.</numerusform>
            <numerusform>%n von mindestens 6 Haltungen sind brauchbar.</numerusform>
        </translation>
    </message>
    <message>
        <source>All directions are covered, but only slightly. Larger tilts give better results.</source>
        <translation>Die Neigungen decken alle Richtungen ein wenig ab: Weitere sagen mehr.</translation>
    </message>
    <message>
        <source>All poses have the same orientation. Tilt the tool by at least 30°.</source>
        <translation>Das Werkzeug hatte bisher nur eine Neigung: Neigen Sie es um mindestens 30 Grad.</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) lost</source>
        <translation>
            <numerusform>%n Messwert verloren</numerusform>
            <numerusform>%n Messwerte verloren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n late</source>
        <translation>
            <numerusform>%n verspätet</numerusform>
            <numerusform>%n verspätet</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unreadable</source>
        <translation>
            <numerusform>%n unlesbar</numerusform>
            <numerusform>%n unlesbar</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reported as faulty by the device</source>
        <translation>
            <numerusform>%n vom Gerät als fehlerhaft gemeldet</numerusform>
            <numerusform>%n vom Gerät als fehlerhaft gemeldet</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>connection lost %n time(s)</source>
        <translation>
            <numerusform>Verbindung %n-mal verloren</numerusform>
            <numerusform>Verbindung %n-mal verloren</numerusform>
        </translation>
    </message>
    <message>
        <source>no samples lost</source>
        <translation>keine Messwerte verloren</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>connecting …</source>
        <translation>verbindet …</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>shake from the wrist</source>
        <translation>aus dem Handgelenk schütteln</translation>
    </message>
    <message>
        <source>under ± 0.1 g</source>
        <translation>unter ± 0,1 g</translation>
    </message>
    <message>
        <source>under ± 0.1 mm</source>
        <translation>unter ± 0,1 mm</translation>
    </message>
    <message>
        <source>swing from the wrist</source>
        <translation>aus dem Handgelenk schwingen</translation>
    </message>
    <message>
        <source>turn back and forth, faster</source>
        <translation>schneller hin und her drehen</translation>
    </message>
    <message>
        <source>Swing the tool from side to side, once per second</source>
        <translation>Schwenken Sie das Werkzeug seitlich hin und her, einmal je Sekunde</translation>
    </message>
    <message>
        <source>Swing the tool back and forth, once per second</source>
        <translation>Schwenken Sie das Werkzeug vor und zurück, einmal je Sekunde</translation>
    </message>
    <message>
        <source>Swing the tool in a circle, once per second</source>
        <translation>Schwenken Sie das Werkzeug im Kreis, einmal je Sekunde</translation>
    </message>
    <message>
        <source>Shake the tool sideways, about three times per second</source>
        <translation>Schütteln Sie das Werkzeug seitlich, etwa dreimal je Sekunde</translation>
    </message>
    <message>
        <source>Shake the tool back and forth, about three times per second</source>
        <translation>Schütteln Sie das Werkzeug vor und zurück, etwa dreimal je Sekunde</translation>
    </message>
    <message>
        <source>Shake the tool about its long axis, two to three times per second</source>
        <translation>Schütteln Sie das Werkzeug um seine Längsachse, zwei- bis dreimal je Sekunde</translation>
    </message>
    <message>
        <source>Nothing more is needed: all values are well known</source>
        <translation>Mehr ist nicht nötig: Alle Werte sind gut bekannt</translation>
    </message>
    <message>
        <source>Not yet: move the tool</source>
        <translation>Noch nicht: Werkzeug bewegen</translation>
    </message>
    <message>
        <source>Not yet: tilt the tool</source>
        <translation>Noch nicht: Werkzeug neigen</translation>
    </message>
    <message>
        <source>Not yet: rotate the tool</source>
        <translation>Noch nicht: Werkzeug drehen</translation>
    </message>
    <message>
        <source>Not yet: rotate faster</source>
        <translation>Noch nicht: schneller drehen</translation>
    </message>
    <message>
        <source>Not yet: tilt more</source>
        <translation>Noch nicht: weiter neigen</translation>
    </message>
    <message>
        <source>too similar to another one</source>
        <translation>einer anderen zu ähnlich</translation>
    </message>
    <message>
        <source>The tool has been tilted about one axis only. Tilt it about another axis, too.</source>
        <translation>Das Werkzeug wurde nur um eine Achse geneigt: Neigen Sie es auch um eine andere.</translation>
    </message>
    <message>
        <source>connection lost, reconnecting …</source>
        <translation>Verbindung verloren, wird neu aufgebaut …</translation>
    </message>
    <message>
        <source>replay finished</source>
        <translation>Wiedergabe beendet</translation>
    </message>
    <message>
        <source>Wobble the tool: tilt it in all directions while twisting it, about twice per second</source>
        <translation>Das Werkzeug wackeln: nach allen Seiten kippen und zugleich drehen, etwa zweimal je Sekunde</translation>
    </message>
    <message>
        <source>wobble: tilt and twist at once</source>
        <translation>wackeln: kippen und drehen zugleich</translation>
    </message>
    <message>
        <source>Shake the tool from the wrist, two to three times per second: tilt it in all directions while twisting it</source>
        <translation>Das Werkzeug aus dem Handgelenk schütteln, zwei- bis dreimal je Sekunde: nach allen Seiten kippen und zugleich drehen</translation>
    </message>
    <message>
        <source>Swing the tool from the wrist, once per second: tilt it in all directions while twisting it</source>
        <translation>Das Werkzeug aus dem Handgelenk schwenken, einmal je Sekunde: nach allen Seiten kippen und zugleich drehen</translation>
    </message>
</context>
<context>
    <name>MarkText</name>
    <message>
        <source>%1 – %2 s</source>
        <translation>%1 – %2 s</translation>
    </message>
    <message>
        <source>No contact detected.</source>
        <translation>Heft fand nichts, was das Werkzeug berührt hat.</translation>
    </message>
    <message>
        <source>high</source>
        <translation>hoch</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>mittel</translation>
    </message>
    <message>
        <source>low</source>
        <translation>niedrig</translation>
    </message>
    <message numerus="yes">
        <source>Only free segments are used. Please review %n suggestion(s).</source>
        <translation>
            <numerusform>Nur freie Abschnitte werden benutzt. Bitte prüfen Sie %n Vorschlag.</numerusform>
            <numerusform>Nur freie Abschnitte werden benutzt. Bitte prüfen Sie %n Vorschläge.</numerusform>
        </translation>
    </message>
    <message>
        <source>Only free segments are used.</source>
        <translation>Nur freie Abschnitte werden benutzt.</translation>
    </message>
    <message>
        <source>Sensor noise: %1 N, %2</source>
        <translation>Sensorrauschen: %1 N, %2</translation>
    </message>
    <message>
        <source>Residual %1 N, %2 RMS</source>
        <translation>Rest %1 N, %2 (RMS)</translation>
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
        <source>&amp;Quit</source>
        <translation>B&amp;eenden</translation>
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
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
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
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>&amp;Robot and sensor …</source>
        <translation>&amp;Roboter und Sensor …</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>D&amp;etails</source>
        <translation>D&amp;etails</translation>
    </message>
    <message>
        <source>&amp;Preferences …</source>
        <translation>&amp;Einstellungen …</translation>
    </message>
    <message>
        <source>&amp;Tour with a sample</source>
        <translation>&amp;Rundgang mit einem Beispiel</translation>
    </message>
    <message>
        <source>&amp;Go to step</source>
        <translation>Zum S&amp;chritt</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>Sitzung &amp;speichern</translation>
    </message>
    <message>
        <source>Save session &amp;as …</source>
        <translation>Sitzung speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Export payload &amp;file …</source>
        <translation>&amp;Payload-Datei exportieren …</translation>
    </message>
    <message>
        <source>Zoom to &amp;whole arm</source>
        <translation>&amp;Ganzer Arm</translation>
    </message>
    <message>
        <source>Zoom to &amp;tool</source>
        <translation>&amp;Werkzeug</translation>
    </message>
    <message>
        <source>Fro&amp;nt</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>Zoom to whole &amp;recording</source>
        <translation>Ganze &amp;Aufnahme zeigen</translation>
    </message>
    <message>
        <source>S&amp;top the current task</source>
        <translation>Laufende Aufgabe an&amp;halten</translation>
    </message>
    <message>
        <source>Estimates the mass, centre of mass and inertia of a robot’s payload. Heft’s source is under the Apache License 2.0; this program links QCustomPlot and may be redistributed under the GNU General Public License, version 3 or later.</source>
        <translation>Schätzt Masse, Schwerpunkt und Trägheit der Last eines Roboters. Der Quelltext von Heft steht unter der Apache-Lizenz 2.0; dieses Programm bindet QCustomPlot ein und darf unter der GNU General Public License, Version 3 oder später, weitergegeben werden.</translation>
    </message>
    <message>
        <source>Save &amp;picture</source>
        <translation>&amp;Bild speichern</translation>
    </message>
    <message>
        <source>&amp;Window …</source>
        <translation>&amp;Fenster …</translation>
    </message>
    <message>
        <source>3D &amp;view …</source>
        <translation>&amp;3D-Ansicht …</translation>
    </message>
    <message>
        <source>&amp;Plots …</source>
        <translation>&amp;Kurven …</translation>
    </message>
    <message>
        <source>Pan&amp;el …</source>
        <translation>&amp;Seite rechts …</translation>
    </message>
    <message>
        <source>Columns and &amp;units …</source>
        <translation>Spalten und &amp;Einheiten …</translation>
    </message>
    <message>
        <source>Maximise &amp;plots</source>
        <translation>&amp;Kurven maximieren</translation>
    </message>
    <message>
        <source>Maximise 3D &amp;view</source>
        <translation>&amp;3D-Ansicht maximieren</translation>
    </message>
</context>
<context>
    <name>MethodTable</name>
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
        <source>Time [ms]</source>
        <translation>Zeit [ms]</translation>
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
    <message>
        <source>Heft (MAP)</source>
        <translation>Heft (MAP)</translation>
    </message>
    <message>
        <source>How the values were determined</source>
        <translation>Wie die Werte bestimmt wurden</translation>
    </message>
    <message>
        <source>Held-out force [N]</source>
        <translation>Ungesehene Kraft [N]</translation>
    </message>
    <message>
        <source>Error on segments that were not used for fitting</source>
        <translation>Fehler auf Abschnitten, die nicht zur Anpassung dienten</translation>
    </message>
    <message>
        <source>Held-out torque [N m]</source>
        <translation>Ungesehenes Moment [N m]</translation>
    </message>
    <message>
        <source>Mass error [%]</source>
        <translation>Fehler Masse [%]</translation>
    </message>
    <message>
        <source>Relative error with respect to the reference value</source>
        <translation>Relativer Fehler gegen den bekannten Wert</translation>
    </message>
    <message>
        <source>Centre error [%]</source>
        <translation>Fehler Schwerpunkt [%]</translation>
    </message>
    <message>
        <source>Inertia error [%]</source>
        <translation>Fehler Trägheit [%]</translation>
    </message>
    <message>
        <source>Relative error about the sensor’s origin, with respect to the reference value</source>
        <translation>Relativer Fehler um den Ursprung des Sensors, gegen den bekannten Wert</translation>
    </message>
    <message>
        <source>From the prepared motion to the result</source>
        <translation>Von der vorbereiteten Bewegung zu den Werten</translation>
    </message>
    <message>
        <source>Physical?</source>
        <translation>Möglich?</translation>
    </message>
    <message>
        <source>Whether a real body can have these values</source>
        <translation>Ob ein wirklicher Körper diese Werte haben kann</translation>
    </message>
</context>
<context>
    <name>ObjectText</name>
    <message>
        <source>It weighs %1.</source>
        <translation>Es wiegt %1.</translation>
    </message>
    <message>
        <source>It seems to weigh %1.</source>
        <translation>Es scheint %1 zu wiegen.</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Centre %1</source>
        <translation>Schwerpunkt %1</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>No object was found: %1, which noise alone could cause.</source>
        <translation>Kein Gegenstand gefunden: %1; so viel kann das Rauschen allein ausmachen.</translation>
    </message>
</context>
<context>
    <name>Passport</name>
    <message>
        <source>A passport needs a result.</source>
        <translation>Ein Pass braucht ein Ergebnis.</translation>
    </message>
    <message>
        <source>%1 already exists and was not overwritten.</source>
        <translation>%1 gibt es schon und wurde nicht ersetzt.</translation>
    </message>
</context>
<context>
    <name>Practice</name>
    <message>
        <source>How to look</source>
        <translation>Worauf achten</translation>
    </message>
    <message>
        <source>When is the residual large – during fast motion, at certain positions, from some time on, always? Does it jump, drift or oscillate? The views below the arm show it by frequency and against the motion.</source>
        <translation>Wann ist die Abweichung groß: bei schnellen Bewegungen, an manchen Orten, ab einem Augenblick, die ganze Zeit? Springt sie, wandert sie, schwingt sie nach? Die Ansichten unter dem Arm zeigen sie nach Frequenz und gegen die Bewegung.</translation>
    </message>
    <message>
        <source>Your guess</source>
        <translation>Ihr Tipp</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Richtig</translation>
    </message>
    <message>
        <source>Your guess, “%1”, would look like this: %2</source>
        <translation>Ihr Tipp „%1“ sähe so aus: %2</translation>
    </message>
    <message>
        <source>How to tell them apart on a real robot: %1</source>
        <translation>So unterscheidet man sie am wirklichen Aufbau: %1</translation>
    </message>
    <message>
        <source>Next exercise</source>
        <translation>Noch eine</translation>
    </message>
    <message>
        <source>Show the answer</source>
        <translation>Lösung zeigen</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Give me a hint</source>
        <translation>Hinweis geben</translation>
    </message>
    <message>
        <source>Not quite</source>
        <translation>Nicht ganz</translation>
    </message>
    <message>
        <source>The hidden fault was: %1.</source>
        <translation>Versteckt war: %1.</translation>
    </message>
    <message>
        <source>Not “%1”. It would look like this: %2 Try once more.</source>
        <translation>Nicht „%1“. Das sähe so aus: %2 Noch ein Versuch.</translation>
    </message>
    <message>
        <source>Solved at the first try: %1 of %2. With a hint or at the second try: %3.</source>
        <translation>Sofort gefunden: %1 von %2. Mit Hinweis oder im zweiten Versuch: %3.</translation>
    </message>
    <message>
        <source>Hide the clean twin</source>
        <translation>Fehlerfreien Zwilling ausblenden</translation>
    </message>
    <message>
        <source>Show the clean twin</source>
        <translation>Fehlerfreien Zwilling zeigen</translation>
    </message>
    <message>
        <source>The same tool and motion without the fault, beside the recording in the curves</source>
        <translation>Dasselbe Werkzeug und dieselbe Bewegung ohne den Fehler, in den Kurven neben der Aufnahme</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Look in:</source>
        <translation>Suchen in:</translation>
    </message>
    <message>
        <source>File &amp;name:</source>
        <translation>Datei&amp;name:</translation>
    </message>
    <message>
        <source>Files of type:</source>
        <translation>Dateien des Typs:</translation>
    </message>
    <message>
        <source>Directory:</source>
        <translation>Ordner:</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>S&amp;peichern</translation>
    </message>
    <message>
        <source>&amp;Choose</source>
        <translation>&amp;Wählen</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Zurückgehen</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Go forward</source>
        <translation>Vorgehen</translation>
    </message>
    <message>
        <source>Parent Directory</source>
        <translation>Übergeordneter Ordner</translation>
    </message>
    <message>
        <source>Go to the parent directory</source>
        <translation>In den übergeordneten Ordner gehen</translation>
    </message>
    <message>
        <source>Create New Folder</source>
        <translation>Neuen Ordner anlegen</translation>
    </message>
    <message>
        <source>Create a New Folder</source>
        <translation>Einen neuen Ordner anlegen</translation>
    </message>
    <message>
        <source>List View</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>Change to list view mode</source>
        <translation>Als Liste zeigen</translation>
    </message>
    <message>
        <source>Detail View</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Change to detail view mode</source>
        <translation>Mit Einzelheiten zeigen</translation>
    </message>
    <message>
        <source>&amp;New Folder</source>
        <translation>&amp;Neuer Ordner</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Show &amp;hidden files</source>
        <translation>&amp;Versteckte Dateien zeigen</translation>
    </message>
    <message>
        <source>Recent Places</source>
        <translation>Zuletzt besucht</translation>
    </message>
    <message>
        <source>%1 already exists.
Do you want to replace it?</source>
        <translation>%1 gibt es schon.
Soll es ersetzt werden?</translation>
    </message>
    <message>
        <source>%1
File not found.
Please verify the correct file name was given.</source>
        <translation>%1
Diese Datei gibt es nicht.
Bitte prüfen Sie den Namen.</translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Date Modified</source>
        <translation>Geändert am</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Ja</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Nein</translation>
    </message>
    <message>
        <source>Don&apos;t Save</source>
        <translation>Nicht speichern</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
</context>
<context>
    <name>ReadingCard</name>
    <message>
        <source>Error in %1 [%2]</source>
        <translation>Fehler in %1 [%2]</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Haltung</translation>
    </message>
    <message>
        <source>as stated</source>
        <translation>wie angegeben</translation>
    </message>
    <message>
        <source>To decide:</source>
        <translation>Zur Entscheidung:</translation>
    </message>
    <message>
        <source>(%1 kg)</source>
        <translation>(%1 kg)</translation>
    </message>
    <message>
        <source>As stated, the tool would weigh %1.</source>
        <translation>Wie angegeben würde das Werkzeug %1 wiegen.</translation>
    </message>
    <message>
        <source>as suggested</source>
        <translation>wie vorgeschlagen</translation>
    </message>
    <message>
        <source>Residual of a rigid tool, as stated and as suggested</source>
        <translation>Rest eines starren Werkzeugs, wie angegeben und wie vorgeschlagen</translation>
    </message>
    <message>
        <source>Differs from the setup file</source>
        <translation>Anders als in der Aufbaudatei</translation>
    </message>
    <message>
        <source>Fits equally well:</source>
        <translation>Passt ebenso:</translation>
    </message>
    <message>
        <source>Check in the driver:</source>
        <translation>Im Treiber prüfen:</translation>
    </message>
    <message>
        <source>Applied</source>
        <translation>Angewandt</translation>
    </message>
    <message>
        <source>Back to the stated conventions</source>
        <translation>Zurück zu den angegebenen Konventionen</translation>
    </message>
    <message>
        <source>Use these conventions</source>
        <translation>Diese Konventionen benutzen</translation>
    </message>
    <message>
        <source>Applies to this session only; the file is not changed. Ctrl+Z undoes it.</source>
        <translation>Gilt nur in dieser Sitzung; die Datei bleibt, wie sie ist. Strg+Z nimmt es zurück.</translation>
    </message>
    <message>
        <source>Several interpretations possible</source>
        <translation>Mehrere Deutungen möglich</translation>
    </message>
    <message>
        <source>Set it in Robot and sensor …</source>
        <translation>Unter Roboter und Sensor angeben …</translation>
    </message>
</context>
<context>
    <name>RealityFiles</name>
    <message>
        <source>There is no reality check yet to correct a setup file from.</source>
        <translation>Es gibt noch keine Realitätsprüfung, aus der sich eine Aufbaudatei berichtigen ließe.</translation>
    </message>
    <message>
        <source>The reality check proposes no change of the setup file.</source>
        <translation>Die Realitätsprüfung schlägt keine Änderung der Aufbaudatei vor.</translation>
    </message>
    <message>
        <source>%1 already exists and was not overwritten.</source>
        <translation>%1 gibt es schon und wurde nicht ersetzt.</translation>
    </message>
    <message>
        <source>Save the corrected setup file</source>
        <translation>Die berichtigte Aufbaudatei speichern</translation>
    </message>
    <message>
        <source>Setup files (*.meta.json)</source>
        <translation>Aufbaudateien (*.meta.json)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
    <message>
        <source>A report needs an open recording.</source>
        <translation>Ein Bericht braucht eine offene Aufnahme.</translation>
    </message>
    <message>
        <source>Open a recording first.</source>
        <translation>Öffnen Sie zuerst eine Aufnahme.</translation>
    </message>
    <message>
        <source>Save report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>PDF (*.pdf);;Web page (*.html)</source>
        <translation>PDF (*.pdf);;Webseite (*.html)</translation>
    </message>
</context>
<context>
    <name>RealityPage</name>
    <message>
        <source>Differences between simulation and measurement:</source>
        <translation>Hier weicht die Simulation von Ihren Daten ab.</translation>
    </message>
    <message>
        <source>The model fits</source>
        <translation>Das Modell passt</translation>
    </message>
    <message>
        <source>No correction needed.</source>
        <translation>Nichts in Ihren Daten verlangt eine Berichtigung.</translation>
    </message>
    <message>
        <source>Something unknown</source>
        <translation>Etwas Unbekanntes</translation>
    </message>
    <message numerus="yes">
        <source>%n correction(s) applied</source>
        <translation>
            <numerusform>%n Berichtigung angewandt</numerusform>
            <numerusform>%n Berichtigungen angewandt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n cause(s) found</source>
        <translation>
            <numerusform>%n Ursache gefunden</numerusform>
            <numerusform>%n Ursachen gefunden</numerusform>
        </translation>
    </message>
    <message>
        <source>Two causes are possible</source>
        <translation>Zwei Ursachen sind möglich</translation>
    </message>
    <message numerus="yes">
        <source>%n findings are still open</source>
        <translation>
            <numerusform>%n Befund ist noch offen</numerusform>
            <numerusform>%n Befunde sind noch offen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n cause(s) found, </source>
        <translation>
            <numerusform>%n Ursache gefunden, </numerusform>
            <numerusform>%n Ursachen gefunden, </numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n still open</source>
        <translation>
            <numerusform>%n noch offen</numerusform>
            <numerusform>%n noch offen</numerusform>
        </translation>
    </message>
    <message>
        <source>Your result changed:</source>
        <translation>Ihr Ergebnis hat sich geändert:</translation>
    </message>
    <message>
        <source>Does it hold on another recording?</source>
        <translation>Gilt es auch für eine andere Aufnahme?</translation>
    </message>
    <message>
        <source>Check on %1</source>
        <translation>An %1 prüfen</translation>
    </message>
    <message>
        <source>None of them explains anything beyond noise.</source>
        <translation>Keine davon erklärt mehr als Rauschen.</translation>
    </message>
    <message>
        <source>Your result stayed the same.</source>
        <translation>Ihr Ergebnis ist gleich geblieben.</translation>
    </message>
    <message>
        <source>Error there: %1 → %2.</source>
        <translation>Fehler dort: %1 → %2.</translation>
    </message>
    <message>
        <source>Also noticed</source>
        <translation>Außerdem bemerkt</translation>
    </message>
    <message>
        <source>Included in result, simulation and export.</source>
        <translation>In Ergebnis, Simulation und Export enthalten.</translation>
    </message>
    <message>
        <source>With all causes applied your result stays the same.</source>
        <translation>Mit allen Ursachen bleibt Ihr Ergebnis gleich.</translation>
    </message>
    <message>
        <source>If you apply it, your result stays the same.</source>
        <translation>Wenn Sie sie anwenden, bleibt Ihr Ergebnis gleich.</translation>
    </message>
    <message>
        <source>With all causes applied your result changes:</source>
        <translation>Mit allen Ursachen ändert sich Ihr Ergebnis:</translation>
    </message>
    <message>
        <source>If you apply it, your result changes:</source>
        <translation>Wenn Sie sie anwenden, ändert sich Ihr Ergebnis:</translation>
    </message>
    <message>
        <source>Enter this under Robot and sensor</source>
        <translation>Das gehört unter „Roboter und Sensor“</translation>
    </message>
    <message>
        <source>Robot and sensor …</source>
        <translation>Roboter und Sensor …</translation>
    </message>
    <message>
        <source>Save as a setup file …</source>
        <translation>Als Aufbaudatei speichern …</translation>
    </message>
    <message>
        <source>Recording to check on</source>
        <translation>Aufnahme zum Prüfen</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message numerus="yes">
        <source>%n cause(s) found, part unexplained</source>
        <translation>
            <numerusform>%n Ursache gefunden, ein Teil unerklärt</numerusform>
            <numerusform>%n Ursachen gefunden, ein Teil unerklärt</numerusform>
        </translation>
    </message>
    <message>
        <source>That is %1 times the stated uncertainty.</source>
        <translation>Das ist das %1-Fache der angegebenen Unsicherheit.</translation>
    </message>
    <message>
        <source>That is within the stated uncertainty.</source>
        <translation>Das ist weniger als die angegebene Unsicherheit.</translation>
    </message>
    <message>
        <source>Writes a copy of the setup file with these entries, for later recordings.</source>
        <translation>Schreibt eine Kopie der Aufbaudatei mit diesen Einträgen; spätere Aufnahmen beginnen dann richtig.</translation>
    </message>
    <message>
        <source>Open another recording of the same setup …</source>
        <translation>Eine andere Aufnahme desselben Aufbaus öffnen …</translation>
    </message>
    <message numerus="yes">
        <source>Also tested: %n cause(s)</source>
        <translation>
            <numerusform>Auch geprüft: %n Ursache</numerusform>
            <numerusform>Auch geprüft: %n Ursachen</numerusform>
        </translation>
    </message>
    <message>
        <source>Not detectable in this recording: %1.</source>
        <translation>In dieser Aufnahme nicht erkennbar: %1.</translation>
    </message>
    <message>
        <source>The smallest size of each cause that this motion and sensor would have revealed.</source>
        <translation>Die kleinste Größe jeder Ursache, die diese Bewegung und dieser Sensor gezeigt hätten.</translation>
    </message>
    <message>
        <source>Mass, centre and inertia stay the same to the digits shown.</source>
        <translation>Masse, Schwerpunkt und Trägheit bleiben in den gezeigten Stellen gleich.</translation>
    </message>
    <message>
        <source>It becomes less certain: %1. Payload and cause are hard to distinguish with this motion.</source>
        <translation>Es wird unsicherer: %1. Last und Ursache sind mit dieser Bewegung schwer zu unterscheiden.</translation>
    </message>
    <message>
        <source>Your result is not reliable, even with the causes corrected.</source>
        <translation>Ihr Ergebnis ist nicht verlässlich, auch nicht mit berichtigten Ursachen.</translation>
    </message>
</context>
<context>
    <name>Remedies</name>
    <message>
        <source>Choose its columns, or add the file that has it.</source>
        <translation>Wählen Sie die Spalten, oder nehmen Sie die Datei dazu, in der es steht.</translation>
    </message>
    <message>
        <source>Choose it under Tools, “Robot and sensor”.</source>
        <translation>Wählen Sie ihn unter Werkzeuge, „Roboter und Sensor“.</translation>
    </message>
    <message>
        <source>Choose the link that carries the sensor under Tools, “Robot and sensor”: one of %1.</source>
        <translation>Wählen Sie das Glied, das den Sensor trägt, unter Werkzeuge, „Roboter und Sensor“: eines von %1.</translation>
    </message>
    <message>
        <source>Set the opposite sign of the force under Tools, “Robot and sensor”.</source>
        <translation>Sagen Sie unter Werkzeuge, „Roboter und Sensor“, dass die Kräfte andersherum zeigen.</translation>
    </message>
    <message>
        <source>Enter how the robot is mounted under Tools, “Robot and sensor”.</source>
        <translation>Sagen Sie unter Werkzeuge, „Roboter und Sensor“, wie der Roboter steht.</translation>
    </message>
    <message>
        <source>Correct how the sensor is turned under Tools, “Robot and sensor”.</source>
        <translation>Berichtigen Sie unter Werkzeuge, „Roboter und Sensor“, wie der Sensor gedreht ist.</translation>
    </message>
    <message>
        <source>To keep them out, paint them as ignored in Mark.</source>
        <translation>Sollen sie draußen bleiben, malen Sie sie unter Markieren als ignoriert an.</translation>
    </message>
    <message>
        <source>Describe the tool’s shape in the step Shape.</source>
        <translation>Sagen Sie unter Form, wie das Werkzeug aussieht.</translation>
    </message>
    <message>
        <source>If so, enter it under Tools, “Robot and sensor”, “Conventions of the numbers”.</source>
        <translation>Wenn ja, sagen Sie es unter Werkzeuge, „Roboter und Sensor“, „Konventionen der Zahlen“.</translation>
    </message>
    <message>
        <source>Enter it under Tools, “Robot and sensor”, “Conventions of the numbers”: %1.</source>
        <translation>Geben Sie es unter Werkzeuge, „Roboter und Sensor“, „Konventionen der Zahlen“ an: %1.</translation>
    </message>
    <message>
        <source>The step Reality check applies it with one click; or enter it under Tools, “Robot and sensor”: %1.</source>
        <translation>Der Schritt Realitätsprüfung liest sie mit einem Klick so; oder geben Sie es unter Werkzeuge, „Roboter und Sensor“ an: %1.</translation>
    </message>
    <message>
        <source>If the file has no clock, state its rate, rate_hz, in the map file beside it.</source>
        <translation>Hat die Datei keine Uhr, nennen Sie ihre Rate, rate_hz, in der Zuordnungsdatei daneben.</translation>
    </message>
    <message>
        <source>Tools, “Columns and units”, shows what there is.</source>
        <translation>Werkzeuge, „Spalten und Einheiten“, zeigt, was es gibt.</translation>
    </message>
    <message>
        <source>If so, choose it under Tools, “Columns and units”.</source>
        <translation>Wenn ja, wählen Sie es unter Werkzeuge, „Spalten und Einheiten“.</translation>
    </message>
    <message>
        <source>You can still choose it.</source>
        <translation>Sie können es trotzdem wählen.</translation>
    </message>
    <message>
        <source>Choose the time column under Tools, “Columns and units”.</source>
        <translation>Wählen Sie die Zeitspalte unter Werkzeuge, „Spalten und Einheiten“.</translation>
    </message>
    <message>
        <source>If you know the offset, enter it under Tools, “Columns and units”.</source>
        <translation>Wenn Sie den Versatz kennen, geben Sie ihn unter Werkzeuge, „Spalten und Einheiten“, ein.</translation>
    </message>
    <message>
        <source>If the rows are standing poses, set this under Tools, “Robot and sensor”; for another unit, see “Columns and units”.</source>
        <translation>Sind die Zeilen stehende Posen, stellen Sie es unter Werkzeuge, „Roboter und Sensor“, ein; eine andere Einheit unter „Spalten und Einheiten“.</translation>
    </message>
</context>
<context>
    <name>ResultPanel</name>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>Flange</source>
        <translation>Flansch</translation>
    </message>
    <message>
        <source>Correlation of the numbers</source>
        <translation>Korrelation der Zahlen</translation>
    </message>
    <message>
        <source>%1 with %2: %3</source>
        <translation>%1 mit %2: %3</translation>
    </message>
    <message>
        <source>In the frame of</source>
        <translation>Im Koordinatensystem von</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>Near 1 or −1, an error of one number comes with an error of the other: this motion does not separate them well. Inertia is about the centre of mass, in the sensor’s axes.</source>
        <translation>Nahe 1 oder −1 geht ein Fehler der einen Zahl mit einem Fehler der anderen einher: Diese Bewegung trennt sie schlecht. Trägheit um den Schwerpunkt, in den Achsen des Sensors.</translation>
    </message>
    <message>
        <source>Copy the details</source>
        <translation>Details kopieren</translation>
    </message>
    <message>
        <source>As a table, for a spreadsheet or a message</source>
        <translation>Als Tabelle für eine Tabellenkalkulation oder eine Nachricht</translation>
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
        <source>Mass, centre of mass and inertia: all measured.</source>
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
        <source>%1 are not fully determined by this motion</source>
        <translation>%1 sind aus dieser Bewegung nicht ganz bekannt</translation>
    </message>
    <message>
        <source>%1 is not fully determined by this motion</source>
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
        <source>Used</source>
        <translation>Benutzt</translation>
    </message>
    <message>
        <source>%1 of %2 s, %3 Hz</source>
        <translation>%1 von %2 s, %3 Hz</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Held-out error</source>
        <translation>Auf ungesehenen Teilen</translation>
    </message>
    <message>
        <source>Sensor bias, force</source>
        <translation>Sensornullpunkt, Kraft</translation>
    </message>
    <message>
        <source>Constant offset x, y, z of the sensor</source>
        <translation>Fester Versatz x, y, z des Sensors</translation>
    </message>
    <message>
        <source>Condition number</source>
        <translation>Konditionszahl</translation>
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
        <source>Deviation from reference</source>
        <translation>Abstand zu Ihren Angaben</translation>
    </message>
    <message>
        <source>Relative error |estimate − stated| / |stated|</source>
        <translation>Relativer Fehler |Schätzung − Angabe| / |Angabe|</translation>
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
        <source>Computation time</source>
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
        <source>Mass of the tool</source>
        <translation>Masse des Werkzeugs</translation>
    </message>
    <message>
        <source>Centre of mass from the sensor&apos;s origin along its axis %1</source>
        <translation>Schwerpunkt vom Ursprung des Sensors entlang seiner Achse %1</translation>
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
        <source>Check the warnings first: the errors may be larger than the intervals.</source>
        <translation>Prüfen Sie zuerst die Warnungen: Diese Werte können weiter daneben liegen, als sie sagen.</translation>
    </message>
    <message>
        <source>%1 % data</source>
        <translation>%1 % Daten</translation>
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
        <source>|estimate − known| / known</source>
        <translation>|Schätzung − bekannt| / bekannt</translation>
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
        <source>‖estimate − known‖ / ‖known‖, Frobenius, about the centre of mass and about the sensor’s origin</source>
        <translation>‖Schätzung − bekannt‖ / ‖bekannt‖, Frobenius, um den Schwerpunkt und um den Ursprung des Sensors</translation>
    </message>
    <message>
        <source>The motion alone gives %1 %3, your shape gives %2 %3.</source>
        <translation>Die Bewegung allein sagte %1 %3, Ihre Form %2 %3.</translation>
    </message>
    <message>
        <source>%1 % your shape</source>
        <translation>%1 % Ihre Form</translation>
    </message>
    <message>
        <source>The weight cannot be determined yet.</source>
        <translation>Noch lässt sich kein Gewicht nennen.</translation>
    </message>
    <message>
        <source>The reality check found a cause that is not applied: %1</source>
        <translation>Die Realitätsprüfung fand eine Ursache, die nicht angewendet ist: %1</translation>
    </message>
    <message>
        <source>The reality check found %1 causes that are not applied: %2</source>
        <translation>Die Realitätsprüfung fand %1 Ursachen, die nicht angewendet sind: %2</translation>
    </message>
    <message>
        <source>With it: %1.</source>
        <translation>Mit ihr: %1.</translation>
    </message>
    <message>
        <source>%1 kg cm² about (%2, %3, %4)</source>
        <translation>%1 kg cm² um (%2; %3; %4)</translation>
    </message>
    <message>
        <source>Principal moments</source>
        <translation>Hauptmomente</translation>
    </message>
    <message>
        <source>%1 %, %2</source>
        <translation>%1 %, %2</translation>
    </message>
    <message>
        <source>Ten independent directions among the parameters, and the share of the data in each; the rest comes from what was assumed</source>
        <translation>Zehn unabhängige Richtungen unter den Parametern und der Anteil der Daten daran; der Rest kommt aus dem, was angenommen wurde</translation>
    </message>
    <message>
        <source>Your tool weighs %1.</source>
        <translation>Ihr Werkzeug wiegt %1.</translation>
    </message>
    <message>
        <source>Your tool seems to weigh %1.</source>
        <translation>Ihr Werkzeug wiegt anscheinend %1.</translation>
    </message>
    <message>
        <source>x, y, z from the flange’s origin along its axes, with the sensor’s mount as stated</source>
        <translation>x, y, z vom Ursprung des Flansches entlang seiner Achsen, mit dem Anbau des Sensors wie angegeben</translation>
    </message>
    <message>
        <source>%1
%2 kg cm²</source>
        <translation>%1
%2 kg cm²</translation>
    </message>
    <message>
        <source>About the centre of mass: xx, yy, zz; xy, xz, yz</source>
        <translation>Um den Schwerpunkt: xx, yy, zz; xy, xz, yz</translation>
    </message>
    <message>
        <source>100 %, %1 of %2 directions</source>
        <translation>100 %, %1 von %2 Richtungen</translation>
    </message>
    <message>
        <source>Resistance to rotation about the axis %1</source>
        <translation>Widerstand gegen Drehung um die Achse %1</translation>
    </message>
    <message>
        <source>Coupling of rotations about %1 and %2</source>
        <translation>Kopplung der Drehungen um %1 und %2</translation>
    </message>
    <message>
        <source>How the values were determined</source>
        <translation>Wie die Werte bestimmt wurden</translation>
    </message>
    <message>
        <source>Free segments, without the trimmed ends</source>
        <translation>Freie Abschnitte ohne die abgeschnittenen Enden</translation>
    </message>
    <message>
        <source>Residual force</source>
        <translation>Rest, Kraft</translation>
    </message>
    <message>
        <source>Root mean square of the residual on free segments</source>
        <translation>Effektivwert des Rests auf freien Abschnitten</translation>
    </message>
    <message>
        <source>Residual torque</source>
        <translation>Rest, Moment</translation>
    </message>
    <message>
        <source>The same on segments that were not used for fitting</source>
        <translation>Dasselbe auf Abschnitten, die nicht zur Anpassung dienten</translation>
    </message>
    <message>
        <source>Sensor bias, torque</source>
        <translation>Sensornullpunkt, Moment</translation>
    </message>
    <message>
        <source>Of the scaled, whitened regressor: how unevenly the motion determines the ten parameters</source>
        <translation>Des skalierten, geweißten Regressors: wie ungleich die Bewegung die zehn Parameter bestimmt</translation>
    </message>
    <message>
        <source>Physically consistent</source>
        <translation>Physikalisch möglich</translation>
    </message>
    <message>
        <source>Positive mass, and an inertia that a real mass distribution can have</source>
        <translation>Positive Masse und eine Trägheit, die eine wirkliche Massenverteilung haben kann</translation>
    </message>
    <message>
        <source>%1 % off the inertia you entered</source>
        <translation>%1 % neben der eingegebenen Trägheit</translation>
    </message>
    <message>
        <source>This motion does not determine the mass.</source>
        <translation>Diese Bewegung bestimmt die Masse nicht.</translation>
    </message>
    <message>
        <source>That shifted the result by %1 σ.</source>
        <translation>Das verschob das Ergebnis um %1 σ.</translation>
    </message>
    <message>
        <source>%1 % off, about the sensor %2 %</source>
        <translation>%1 % daneben, um den Sensor %2 %</translation>
    </message>
    <message>
        <source>%1 rely on your shape</source>
        <translation>%1 stützen sich auf Ihre Form</translation>
    </message>
    <message>
        <source>%1 relies on your shape</source>
        <translation>%1 stützt sich auf Ihre Form</translation>
    </message>
    <message>
        <source>The readings do not determine it with this interpretation.</source>
        <translation>So gedeutet, bestimmen die Messwerte es nicht.</translation>
    </message>
    <message>
        <source>shifted by your shape, %1 σ</source>
        <translation>von Ihrer Form verschoben, %1 σ</translation>
    </message>
    <message>
        <source>%1 % off the inertia that the recording states</source>
        <translation>%1 % von der Trägheit, die die Aufnahme nennt</translation>
    </message>
    <message>
        <source>Determined by the motion</source>
        <translation>Aus der Bewegung bestimmt</translation>
    </message>
    <message>
        <source>Force by channel</source>
        <translation>Kraft je Kanal</translation>
    </message>
    <message>
        <source>Root mean square of the residual in x, y, z, and the sensor’s noise</source>
        <translation>Effektivwert des Rests in x, y, z und das Rauschen des Sensors</translation>
    </message>
    <message>
        <source>Torque by channel</source>
        <translation>Moment je Kanal</translation>
    </message>
    <message>
        <source>%1 known, %2 % off</source>
        <translation>%1 bekannt, %2 % daneben</translation>
    </message>
    <message>
        <source>%1 %2 off</source>
        <translation>%1 %2 daneben</translation>
    </message>
    <message>
        <source>you entered %1, %2 % off</source>
        <translation>Ihre Angabe %1, %2 % daneben</translation>
    </message>
    <message>
        <source>the recording has %1, %2 % off</source>
        <translation>laut Aufnahme %1, %2 % daneben</translation>
    </message>
    <message>
        <source>%1 %2 off the centre you entered</source>
        <translation>%1 %2 von Ihrem angegebenen Schwerpunkt</translation>
    </message>
    <message>
        <source>%1 %2 off the centre that the recording states</source>
        <translation>%1 %2 vom Schwerpunkt, den die Aufnahme nennt</translation>
    </message>
    <message>
        <source>Moments about the principal axes through the centre of mass, and these axes in the frame chosen</source>
        <translation>Momente um die Hauptachsen durch den Schwerpunkt, und diese Achsen im gewählten Koordinatensystem</translation>
    </message>
    <message>
        <source>Singular values</source>
        <translation>Singulärwerte</translation>
    </message>
    <message>
        <source>Of the same matrix: a small one is a combination that the motion hardly determines</source>
        <translation>Derselben Matrix: Ein kleiner ist eine Kombination, die die Bewegung kaum bestimmt</translation>
    </message>
    <message>
        <source>x, y, z from the sensor’s origin along its axes</source>
        <translation>x, y, z vom Ursprung des Sensors entlang seiner Achsen</translation>
    </message>
    <message>
        <source>Inertia about the centre</source>
        <translation>Trägheit um den Schwerpunkt</translation>
    </message>
    <message>
        <source>Inertia about the origin</source>
        <translation>Trägheit um den Ursprung</translation>
    </message>
    <message>
        <source>About the frame’s origin: xx, yy, zz; xy, xz, yz</source>
        <translation>Um den Ursprung des Koordinatensystems: xx, yy, zz; xy, xz, yz</translation>
    </message>
    <message>
        <source>%1 N
noise %2</source>
        <translation>%1 N
Rauschen %2</translation>
    </message>
    <message>
        <source>%1 %2
noise %3</source>
        <translation>%1 %2
Rauschen %3</translation>
    </message>
    <message>
        <source>%1 are doubtful</source>
        <translation>%1 sind zweifelhaft</translation>
    </message>
    <message>
        <source>%1 is doubtful</source>
        <translation>%1 ist zweifelhaft</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>zweifelhaft</translation>
    </message>
</context>
<context>
    <name>RobotChoice</name>
    <message>
        <source>%1 has %2 joints, the recording %3: choose the description of the robot that was recorded.</source>
        <translation>%1 hat %2 Gelenke, die Aufnahme %3: Wählen Sie die Beschreibung des Roboters, der aufgenommen wurde.</translation>
    </message>
    <message>
        <source>%1 has no link “%2”: choose the link that carries the sensor under Tools, “Robot and sensor”.</source>
        <translation>%1 hat kein Glied „%2“: Wählen Sie das Glied, das den Sensor trägt, unter Werkzeuge, „Roboter und Sensor“.</translation>
    </message>
</context>
<context>
    <name>Samples</name>
    <message>
        <source>A clean demonstration, 0.8 kg</source>
        <translation>Eine saubere Vorführung, 0,8 kg</translation>
    </message>
    <message>
        <source>A hose pulls at the tool</source>
        <translation>Ein Schlauch zieht am Werkzeug</translation>
    </message>
    <message>
        <source>The force readings come late</source>
        <translation>Die Kraftmesswerte kommen zu spät</translation>
    </message>
</context>
<context>
    <name>SessionReport</name>
    <message>
        <source>Torque [N m]</source>
        <translation>Drehmoment [N m]</translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation>Kraft [N]</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>dashed: simulated</source>
        <translation>gestrichelt: simuliert</translation>
    </message>
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
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Standing poses</source>
        <translation>Stehende Posen</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>%1 s at %2 Hz, %3 samples</source>
        <translation>%1 s mit %2 Hz, %3 Werte</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Centre %1</source>
        <translation>Schwerpunkt %1</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>From [s]</source>
        <translation>Von [s]</translation>
    </message>
    <message>
        <source>To [s]</source>
        <translation>Bis [s]</translation>
    </message>
    <message>
        <source> (applied)</source>
        <translation> (angewandt)</translation>
    </message>
    <message>
        <source>Equally possible with this motion: %1. To decide: %2</source>
        <translation>Mit dieser Bewegung ebenso möglich: %1. Zum Entscheiden: %2</translation>
    </message>
    <message>
        <source>Reality check: %1</source>
        <translation>Realitätsprüfung: %1</translation>
    </message>
    <message>
        <source>The remaining error is related to %1; no known cause accounts for it.</source>
        <translation>Es bleibt etwas, das mit %1 zusammenhängt; keine bekannte Ursache erklärt es.</translation>
    </message>
    <message>
        <source>Frequency [Hz]</source>
        <translation>Frequenz [Hz]</translation>
    </message>
    <message>
        <source>Heft report: %1</source>
        <translation>Heft-Bericht: %1</translation>
    </message>
    <message>
        <source>Heft Studio %1, %2</source>
        <translation>Heft Studio %1, %2</translation>
    </message>
    <message>
        <source>%1 already exists and was not overwritten.</source>
        <translation>%1 gibt es schon und wurde nicht ersetzt.</translation>
    </message>
    <message>
        <source>Heft report</source>
        <translation>Heft-Bericht</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Beweis</translation>
    </message>
    <message>
        <source>Torque, measured minus simulated [N m]</source>
        <translation>Drehmoment, gemessen minus simuliert [N m]</translation>
    </message>
    <message>
        <source>Force, measured minus simulated [N]</source>
        <translation>Kraft, gemessen minus simuliert [N]</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Compared with reference values</source>
        <translation>Verglichen mit Vergleichswerten</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Held-out error %1 → %2; noise floor %3.</source>
        <translation>Ungesehener Fehler %1 → %2; Rauschen %3.</translation>
    </message>
    <message>
        <source>Check on the robot: %1</source>
        <translation>Am Roboter prüfen: %1</translation>
    </message>
    <message>
        <source>The remaining error is sensor noise: %1.</source>
        <translation>Es bleibt nur das Rauschen des Sensors: %1.</translation>
    </message>
    <message>
        <source>Not detectable in this recording: %1.</source>
        <translation>In dieser Aufnahme nicht erkennbar: %1.</translation>
    </message>
    <message>
        <source>With all causes applied, mass and centre stay the same.</source>
        <translation>Mit allen Ursachen bleiben Masse und Schwerpunkt gleich.</translation>
    </message>
    <message>
        <source>What the controller’s current entry costs</source>
        <translation>Was der aktuelle Eintrag in der Steuerung kostet</translation>
    </message>
    <message>
        <source>It was made with different numbers.</source>
        <translation>Er wurde mit anderen Zahlen geführt.</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>Labelled segments</source>
        <translation>Markierte Abschnitte</translation>
    </message>
    <message>
        <source>With all causes applied, the result changes: %1 (%2 times its stated uncertainty).</source>
        <translation>Mit allen Ursachen ändert sich das Ergebnis: %1 (das %2-Fache der angegebenen Unsicherheit).</translation>
    </message>
    <message>
        <source>Torque residual spectrum [N m/√Hz]</source>
        <translation>Spektrum der Drehmomentabweichung [N m/√Hz]</translation>
    </message>
    <message>
        <source>Force residual spectrum [N/√Hz]</source>
        <translation>Spektrum der Kraftabweichung [N/√Hz]</translation>
    </message>
    <message>
        <source>causes corrected</source>
        <translation>Ursachen korrigiert</translation>
    </message>
    <message>
        <source>uncorrected</source>
        <translation>unkorrigiert</translation>
    </message>
    <message>
        <source>No recording is open.</source>
        <translation>Es ist keine Aufnahme geöffnet.</translation>
    </message>
    <message>
        <source>The motion of the arm</source>
        <translation>Die Bewegung des Arms</translation>
    </message>
    <message>
        <source>%1: the name of a report must end in .html or .pdf.</source>
        <translation>%1: Der Name eines Berichts muss auf .html oder .pdf enden.</translation>
    </message>
    <message>
        <source>%1 (sensor)</source>
        <translation>%1 (Sensor)</translation>
    </message>
    <message>
        <source>%1 (flange)</source>
        <translation>%1 (Flansch)</translation>
    </message>
    <message>
        <source>The result is not reliable, even with the causes corrected: %1</source>
        <translation>Das Ergebnis ist nicht verlässlich, auch nicht mit berichtigten Ursachen: %1</translation>
    </message>
</context>
<context>
    <name>SetupWords</name>
    <message>
        <source>Along the axes of</source>
        <translation>Entlang der Achsen</translation>
    </message>
    <message>
        <source>UR’s TCP force, for instance, is along the axes of the robot’s base</source>
        <translation>Die TCP-Kraft von UR zum Beispiel steht in den Achsen des Robotersockels</translation>
    </message>
    <message>
        <source>the sensor</source>
        <translation>des Sensors</translation>
    </message>
    <message>
        <source>the robot’s base</source>
        <translation>des Robotersockels</translation>
    </message>
    <message>
        <source>Torque about</source>
        <translation>Moment um</translation>
    </message>
    <message>
        <source>The reference point of the torque</source>
        <translation>Der Punkt, um den das Moment genommen ist</translation>
    </message>
    <message>
        <source>the sensor’s origin</source>
        <translation>den Ursprung des Sensors</translation>
    </message>
    <message>
        <source>the base’s origin</source>
        <translation>den Ursprung des Sockels</translation>
    </message>
    <message>
        <source>another point of the sensor</source>
        <translation>einen anderen Punkt des Sensors</translation>
    </message>
    <message>
        <source>Force direction</source>
        <translation>Richtung der Kraft</translation>
    </message>
    <message>
        <source>Hold the tool still: which way does the force point?</source>
        <translation>Werkzeug ruhig gehalten: Wohin zeigt die Kraft?</translation>
    </message>
    <message>
        <source>up when the tool hangs at rest</source>
        <translation>nach oben, wenn das Werkzeug ruhig hängt</translation>
    </message>
    <message>
        <source>down when the tool hangs at rest</source>
        <translation>nach unten, wenn das Werkzeug ruhig hängt</translation>
    </message>
    <message>
        <source>Torque sign</source>
        <translation>Vorzeichen des Drehmoments</translation>
    </message>
    <message>
        <source>Some drivers invert the torque but not the force</source>
        <translation>Manche Treiber drehen das Moment um, die Kraft aber nicht</translation>
    </message>
    <message>
        <source>as for the force</source>
        <translation>wie das der Kraft</translation>
    </message>
    <message>
        <source>opposite to the force</source>
        <translation>entgegengesetzt zu dem der Kraft</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>What the first three of the six columns are</source>
        <translation>Was die ersten drei der sechs Spalten sind</translation>
    </message>
    <message>
        <source>force, then torque</source>
        <translation>Kraft, dann Moment</translation>
    </message>
    <message>
        <source>torque, then force</source>
        <translation>Moment, dann Kraft</translation>
    </message>
    <message>
        <source>Mirrored axis</source>
        <translation>Gespiegelte Achse</translation>
    </message>
    <message>
        <source>The axis along which force and torque have the opposite sign: a left-handed sensor</source>
        <translation>Die Achse, entlang der Kraft und Moment das andere Vorzeichen haben: ein linkshändiger Sensor</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Unit of force</source>
        <translation>Einheit der Kraft</translation>
    </message>
    <message>
        <source>Unit used in the file</source>
        <translation>Einheit in der Datei</translation>
    </message>
    <message>
        <source>Unit of torque</source>
        <translation>Einheit des Drehmoments</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Joint angles and their speeds</source>
        <translation>Gelenkwinkel und ihre Geschwindigkeiten</translation>
    </message>
    <message>
        <source>radians</source>
        <translation>Bogenmaß</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Positionen</translation>
    </message>
    <message>
        <source>Positions and their speeds</source>
        <translation>Positionen und ihre Geschwindigkeiten</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>A pose describes</source>
        <translation>Eine Pose ist die</translation>
    </message>
    <message>
        <source>Some programs write the inverse pose</source>
        <translation>Manche Programme schreiben die Pose andersherum</translation>
    </message>
    <message>
        <source>the sensor in the base</source>
        <translation>des Sensors im Sockel</translation>
    </message>
    <message>
        <source>the base in the sensor</source>
        <translation>des Sockels im Sensor</translation>
    </message>
    <message>
        <source>Quaternions</source>
        <translation>Quaternionen</translation>
    </message>
    <message>
        <source>Position of the real part w</source>
        <translation>Wo der Realteil w steht</translation>
    </message>
    <message>
        <source>Recording type</source>
        <translation>Art der Aufnahme</translation>
    </message>
    <message>
        <source>Standing poses: one row per pose; times are ignored</source>
        <translation>Stehende Posen: eine Zeile je Pose; Zeiten zählen nicht</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>standing poses</source>
        <translation>stehende Posen</translation>
    </message>
    <message>
        <source>Sensor’s origin x, y, z</source>
        <translation>Ursprung des Sensors x, y, z</translation>
    </message>
    <message>
        <source>Sensor’s rotation x, y, z</source>
        <translation>Drehung des Sensors x, y, z</translation>
    </message>
    <message>
        <source>Gravity x, y, z</source>
        <translation>Schwerkraft x, y, z</translation>
    </message>
</context>
<context>
    <name>ShapeText</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Tube</source>
        <translation>Rohr</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>Capsule</source>
        <translation>Kapsel</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Greifer</translation>
    </message>
    <message>
        <source>CAD mesh</source>
        <translation>CAD-Netz</translation>
    </message>
    <message>
        <source>width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>%1 kg</source>
        <translation>%1 kg</translation>
    </message>
    <message>
        <source>Move the tool freely</source>
        <translation>Werkzeug frei verschieben</translation>
    </message>
    <message>
        <source>Move the tool along %1</source>
        <translation>Werkzeug entlang %1 verschieben</translation>
    </message>
    <message>
        <source>Tilt the tool about %1</source>
        <translation>Werkzeug um %1 neigen</translation>
    </message>
    <message>
        <source>Choose part %1</source>
        <translation>Teil %1 wählen</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>not specified</source>
        <translation>noch nicht gesagt</translation>
    </message>
    <message>
        <source>none (motion only)</source>
        <translation>unbekannt, nur Bewegung</translation>
    </message>
    <message>
        <source>gripper-like, 2 boxes</source>
        <translation>wie ein Greifer, 2 Quader</translation>
    </message>
    <message numerus="yes">
        <source>%n part(s)</source>
        <translation>
            <numerusform>%n Teil</numerusform>
            <numerusform>%n Teile</numerusform>
        </translation>
    </message>
    <message>
        <source>Rough: the drawing is right to about 10 %, and the material may differ from part to part.</source>
        <translation>Grob: Die Zeichnung stimmt auf etwa 10 %, und das Material darf von Teil zu Teil anders sein.</translation>
    </message>
    <message>
        <source>Rough: within about 20 % (by eye).</source>
        <translation>Grob: Jede Länge stimmt auf etwa 20 %, nach Augenmaß.</translation>
    </message>
    <message>
        <source>Good: CAD of this tool, within about 2 %.</source>
        <translation>Gut: genau dieses Werkzeug, auf etwa 2 % richtig.</translation>
    </message>
    <message>
        <source>Good: each length is right to about 4 %, like a ruler reading.</source>
        <translation>Gut: Jede Länge stimmt auf etwa 4 %, wie mit dem Lineal gemessen.</translation>
    </message>
    <message>
        <source>Exact: from drawings, uniform material.</source>
        <translation>Genau: nach der Zeichnung, und innen überall dasselbe Material.</translation>
    </message>
    <message>
        <source>Steel</source>
        <translation>Stahl</translation>
    </message>
    <message>
        <source>Aluminium</source>
        <translation>Aluminium</translation>
    </message>
    <message>
        <source>Plastic</source>
        <translation>Kunststoff</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Holz</translation>
    </message>
    <message>
        <source>A wall of %1 is too thick for this size: it must be thinner than %2.</source>
        <translation>Eine Wand von %1 lässt keinen Hohlraum: Sie muss dünner als %2 sein.</translation>
    </message>
    <message>
        <source>this material</source>
        <translation>diesem Material</translation>
    </message>
    <message>
        <source>shape expects box, cylinder, tube, sphere, cone, capsule, plate, gripper, several, mesh or unknown, not “%1”.</source>
        <translation>shape erwartet box, cylinder, tube, sphere, cone, capsule, plate, gripper, several, mesh oder unknown, nicht „%1“.</translation>
    </message>
    <message>
        <source>shape mesh expects a file: shape mesh tool.stl mm</source>
        <translation>shape mesh erwartet eine Datei: shape mesh tool.stl mm</translation>
    </message>
    <message>
        <source>“at” expects x,y,z in mm, or with roll, pitch and yaw in degrees: at 0,0,60</source>
        <translation>„at“ erwartet x,y,z in mm, oder mit Roll-, Nick- und Gierwinkel in Grad: at 0,0,60</translation>
    </message>
    <message>
        <source>“%1” expects a number.</source>
        <translation>„%1“ erwartet eine Zahl.</translation>
    </message>
    <message>
        <source>“of” expects steel, aluminium, plastic or wood.</source>
        <translation>„of“ erwartet steel, aluminium, plastic oder wood.</translation>
    </message>
    <message>
        <source>“%1” is not understood after shape; see heft-studio --help.</source>
        <translation>„%1“ wird nach shape nicht verstanden; siehe heft-studio --help.</translation>
    </message>
    <message>
        <source>%1 needs %2 in mm, separated by x.</source>
        <translation>%1 braucht %2 in mm mit x dazwischen.</translation>
    </message>
    <message>
        <source>Assembly</source>
        <translation>Baugruppe</translation>
    </message>
    <message>
        <source>outer</source>
        <translation>außen</translation>
    </message>
    <message>
        <source>inner</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>The inner diameter must be smaller than the outer one, %1.</source>
        <translation>Der innere Durchmesser muss kleiner sein als der äußere, %1.</translation>
    </message>
    <message>
        <source>The parts together weigh %1, more than the whole tool (%2).</source>
        <translation>Die Teile wiegen zusammen %1, mehr als das ganze Werkzeug mit %2.</translation>
    </message>
    <message>
        <source>In %1 it would weigh %2, more than the scale shows (%3): make it hollow, or choose another material.</source>
        <translation>Aus %1 würde es %2 wiegen, mehr als die Waage zeigt (%3): Machen Sie es hohl, oder nehmen Sie ein anderes Material.</translation>
    </message>
    <message>
        <source>“%1” is not a valid size: give lengths in mm, separated by x.</source>
        <translation>„%1“ ist keine gültige Größe: Längen in mm, getrennt durch x.</translation>
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
    <message>
        <source>Record a second of free motion before the contact.</source>
        <translation>Nehmen Sie vor dem Kontakt eine Sekunde freie Bewegung auf.</translation>
    </message>
    <message>
        <source>Estimate the payload from this recording, or diagnose it.</source>
        <translation>Bestimmen Sie die Last aus dieser Aufnahme, oder suchen Sie die Ursache.</translation>
    </message>
    <message>
        <source>The reality check&apos;s corrections are part of these numbers: {}.</source>
        <translation>Die Berichtigungen der Realitätsprüfung stecken in diesen Zahlen: {}.</translation>
    </message>
    <message>
        <source>The sensor zero drifts slowly; this is compensated.</source>
        <translation>Der Nullpunkt des Sensors wandert während der Aufnahme langsam; das ist berücksichtigt.</translation>
    </message>
    <message>
        <source>Let the sensor warm up, and keep recordings short.</source>
        <translation>Lassen Sie den Sensor warm werden, und halten Sie die Aufnahmen kurz.</translation>
    </message>
    <message>
        <source>Repeat the recording without touching anything.</source>
        <translation>Wiederholen Sie die Aufnahme, ohne etwas zu berühren.</translation>
    </message>
    <message>
        <source>The searched region shrank to nothing.</source>
        <translation>Der abgesuchte Bereich schrumpfte auf nichts.</translation>
    </message>
    <message>
        <source>Converged: steps no longer change the result.</source>
        <translation>Fertig: Weitere Schritte ändern das Ergebnis nicht mehr.</translation>
    </message>
    <message>
        <source>Converged: the residual is orthogonal to every direction.</source>
        <translation>Fertig: Der Rest steht auf jeder Richtung senkrecht.</translation>
    </message>
    <message>
        <source>Stopped after the largest number of evaluations.</source>
        <translation>Nach der größten Zahl von Auswertungen beendet.</translation>
    </message>
    <message>
        <source>Converged to rounding.</source>
        <translation>Fertig bis auf Rundung.</translation>
    </message>
    <message>
        <source>Stopped with improper input.</source>
        <translation>Beendet, weil die Eingaben nicht passten.</translation>
    </message>
    <message>
        <source>The mass lies inside the shape even without the bound.</source>
        <translation>Die Masse liegt auch ohne die Grenze innerhalb der Form.</translation>
    </message>
    <message>
        <source>The shape seems too small or misplaced: check it, or leave the bound out.</source>
        <translation>Die Form scheint zu klein oder falsch platziert: Prüfen Sie sie, oder lassen Sie die Grenze weg.</translation>
    </message>
    <message>
        <source>The centre of mass is not given, so it was estimated together with the mass.</source>
        <translation>Der Schwerpunkt ist nicht angegeben, deshalb wurde er mit der Masse zusammen bestimmt.</translation>
    </message>
    <message>
        <source>Give it with --known to hold it fixed.</source>
        <translation>Geben Sie ihn mit --known an, um ihn festzuhalten.</translation>
    </message>
    <message>
        <source>Give it with --known, or a shape with --shape.</source>
        <translation>Geben Sie sie mit --known an, oder eine Form mit --shape.</translation>
    </message>
    <message>
        <source>the sensor&apos;s x axis</source>
        <translation>die x-Achse des Sensors</translation>
    </message>
    <message>
        <source>the sensor&apos;s y axis</source>
        <translation>die y-Achse des Sensors</translation>
    </message>
    <message>
        <source>the sensor&apos;s z axis</source>
        <translation>die z-Achse des Sensors</translation>
    </message>
    <message>
        <source>(near the sensor&apos;s {})</source>
        <translation>(nahe der {}-Achse des Sensors)</translation>
    </message>
    <message>
        <source>an axis across the tool</source>
        <translation>eine Achse quer zum Werkzeug</translation>
    </message>
    <message>
        <source>the tool&apos;s long axis</source>
        <translation>die Längsachse des Werkzeugs</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>centre of mass along {}</source>
        <translation>Schwerpunkt bezogen auf {}</translation>
    </message>
    <message>
        <source>rotation about {}</source>
        <translation>Drehung um {}</translation>
    </message>
    <message>
        <source>coupling of rotations about {} and {}</source>
        <translation>Kopplung der Drehungen um {} und {}</translation>
    </message>
    <message>
        <source>The tool kept nearly the same tilt (about {:.0f} degrees of change), so its weight cannot be separated from the sensor&apos;s bias.</source>
        <translation>Das Werkzeug blieb fast gleich geneigt (etwa {:.0f} Grad Änderung); sein Gewicht lässt sich so nicht vom Nullpunkt des Sensors trennen.</translation>
    </message>
    <message>
        <source>The tool was not tilted in enough directions to determine its centre of mass along {}.</source>
        <translation>Das Werkzeug wurde nicht in genug Richtungen geneigt, um zu sagen, wo sein Schwerpunkt entlang {} liegt.</translation>
    </message>
    <message>
        <source>{:.1f} to {:.1f} s</source>
        <translation>{:.1f} bis {:.1f} s</translation>
    </message>
    <message>
        <source>{} and {} more</source>
        <translation>{} und {} weitere</translation>
    </message>
    <message>
        <source>Mark them by hand if that is wrong.</source>
        <translation>Markieren Sie sie von Hand, wenn das falsch ist.</translation>
    </message>
    <message>
        <source>A plain fit gives a mass of {:.2f} kg: the wrench seems to have the opposite sign.</source>
        <translation>Eine einfache Anpassung ergibt eine Masse von {:.2f} kg: Die Kräfte haben wohl das andere Vorzeichen.</translation>
    </message>
    <message>
        <source>Set sensor.wrench_sign in the setup file to the other convention (sensor_on_payload or payload_on_sensor).</source>
        <translation>Setzen Sie sensor.wrench_sign in der Aufbaudatei auf den anderen Wert (sensor_on_payload oder payload_on_sensor).</translation>
    </message>
    <message>
        <source>centre along {}</source>
        <translation>Schwerpunkt entlang {}</translation>
    </message>
    <message>
        <source>inertia {}</source>
        <translation>Trägheit {}</translation>
    </message>
    <message>
        <source>{} ({:.0f} sigma)</source>
        <translation>{} ({:.0f} Sigma)</translation>
    </message>
    <message>
        <source>This motion does not determine the mass; the number is a placeholder.</source>
        <translation>Diese Bewegung verrät die Masse nicht; die Zahl ist ein Platzhalter.</translation>
    </message>
    <message>
        <source>This motion does not determine the whole centre of mass; what is marked &quot;none&quot; is a placeholder.</source>
        <translation>Diese Bewegung verrät den Schwerpunkt nicht ganz; was nicht bekannt ist, ist ein Platzhalter.</translation>
    </message>
    <message>
        <source>Tilt the tool about more axes.</source>
        <translation>Neigen Sie das Werkzeug um mehr Achsen.</translation>
    </message>
    <message>
        <source>This motion does not determine {} of the three moments of inertia; they are placeholders with wide intervals.</source>
        <translation>Diese Bewegung verrät {} der drei Trägheitsmomente nicht; sie sind Platzhalter mit weiten Bereichen.</translation>
    </message>
    <message>
        <source>centre of mass</source>
        <translation>Schwerpunkt</translation>
    </message>
    <message>
        <source>inertia</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>Use the method map, which always gives a possible payload.</source>
        <translation>Nehmen Sie das Verfahren map, das immer eine mögliche Last ergibt.</translation>
    </message>
    <message>
        <source>The solver did not reach a trustworthy solution: {}</source>
        <translation>Das Verfahren kam zu keiner vertrauenswürdigen Lösung: {}</translation>
    </message>
    <message>
        <source>Use the method map.</source>
        <translation>Nehmen Sie das Verfahren map.</translation>
    </message>
    <message>
        <source>Solved in one step.</source>
        <translation>In einem Schritt gelöst.</translation>
    </message>
    <message>
        <source>This motion leaves some parameters without any information.</source>
        <translation>Diese Bewegung sagt über einige Größen gar nichts.</translation>
    </message>
    <message>
        <source>Could not find a material density that fits this shape.</source>
        <translation>Die Suche nach dem Material der Form kam zu keinem Ende.</translation>
    </message>
    <message>
        <source>Check the recording&apos;s frame and sign, or use a lighter tool.</source>
        <translation>Prüfen Sie Achsen und Vorzeichen der Aufnahme, oder nehmen Sie ein leichteres Werkzeug.</translation>
    </message>
    <message>
        <source>Check the units of the inertia.</source>
        <translation>Prüfen Sie die Einheit der Trägheit.</translation>
    </message>
    <message>
        <source>This format has no products of inertia; up to {:.3g} kg m2 are left out.</source>
        <translation>Dieses Format kennt keine Deviationsmomente; bis zu {:.3g} kg m² fallen weg.</translation>
    </message>
    <message>
        <source>The tool centre point is written at the flange.</source>
        <translation>Als Werkzeugmittelpunkt steht der Flansch in der Datei.</translation>
    </message>
    <message>
        <source>The tool&apos;s rotation is left out: this format&apos;s angle unit is not known.</source>
        <translation>Die Drehung des Werkzeugs fehlt: Die Winkeleinheit dieses Formats ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Set the rotation in Desk.</source>
        <translation>Setzen Sie die Drehung in Desk.</translation>
    </message>
    <message>
        <source>Not checked against a primary source: {}.</source>
        <translation>Nicht an einer Quelle des Herstellers geprüft: {}.</translation>
    </message>
    <message>
        <source>Compare the file with one that your controller wrote.</source>
        <translation>Vergleichen Sie die Datei mit einer, die Ihre Steuerung geschrieben hat.</translation>
    </message>
    <message>
        <source>the name of the service, /service_server/set_load</source>
        <translation>der Name des Dienstes, /service_server/set_load</translation>
    </message>
    <message>
        <source>the syntax of the line (its units and angles are)</source>
        <translation>die Schreibweise der Zeile (Einheiten und Winkel sind es)</translation>
    </message>
    <message>
        <source>the unit of the inertia, kgf cm s2</source>
        <translation>die Einheit der Trägheit, kgf cm s²</translation>
    </message>
    <message>
        <source>centre of mass {}</source>
        <translation>Schwerpunkt {}</translation>
    </message>
    <message>
        <source>inertia {}{}</source>
        <translation>Trägheit {}{}</translation>
    </message>
    <message>
        <source>Not known from this motion, so only a guess: {}.</source>
        <translation>Aus dieser Bewegung nicht bekannt, also nur geraten: {}.</translation>
    </message>
    <message>
        <source>The selected datasets hold more than {} million numbers; the rest was not read.</source>
        <translation>Die gewählten Datensätze enthalten mehr als {} Millionen Zahlen; der Rest wurde nicht gelesen.</translation>
    </message>
    <message>
        <source>The dataset /{} is damaged or cut off.</source>
        <translation>Der Datensatz /{} ist beschädigt oder abgeschnitten.</translation>
    </message>
    <message>
        <source>Not every topic stamps its messages, so the recorder&apos;s times are used for all.</source>
        <translation>Nicht jedes Topic stempelt seine Nachrichten, deshalb gelten für alle die Zeiten des Rekorders.</translation>
    </message>
    <message>
        <source>{} of {} samples of {} lack a value and were left out.</source>
        <translation>{} von {} Messungen von {} fehlt ein Wert; sie wurden ausgelassen.</translation>
    </message>
    <message>
        <source>{} of {} samples of {} repeat a time and were left out.</source>
        <translation>{} von {} Messungen von {} wiederholen eine Zeit und wurden ausgelassen.</translation>
    </message>
    <message>
        <source>{} and {} are on different clocks: the wrench was shifted by {}.</source>
        <translation>{} und {} laufen nach verschiedenen Uhren: Die Kräfte wurden um {} verschoben.</translation>
    </message>
    <message>
        <source>On their common clock the force of {} follows the motion of {} best when shifted by {}; nothing was shifted.</source>
        <translation>Nach der gemeinsamen Uhr folgt die Kraft von {} der Bewegung von {} am besten, wenn sie um {} verschoben wird; verschoben wurde nichts.</translation>
    </message>
    <message>
        <source>{} ({:.4g} Hz) and {} ({:.4g} Hz) were joined on the times of {}; {}.</source>
        <translation>{} ({:.4g} Hz) und {} ({:.4g} Hz) wurden auf den Zeiten von {} zusammengeführt; {}.</translation>
    </message>
    <message>
        <source>the faster one is averaged over each step</source>
        <translation>der schnellere Strom wird über jeden Schritt gemittelt</translation>
    </message>
    <message>
        <source>the other one is interpolated</source>
        <translation>der andere wird interpoliert</translation>
    </message>
    <message>
        <source>The motion comes at {:.3g} Hz only; inertia needs about 100 Hz or more.</source>
        <translation>Die Bewegung kommt nur mit {:.3g} Hz; die Trägheit braucht etwa 100 Hz oder mehr.</translation>
    </message>
    <message>
        <source>Panda&apos;s ROS driver publishes at 30 Hz by default: raise its publish rate to 1000 Hz.</source>
        <translation>Der ROS-Treiber des Panda sendet von sich aus mit 30 Hz: Stellen Sie seine Rate auf 1000 Hz.</translation>
    </message>
    <message>
        <source>{} chunks of the file are damaged; what could be unpacked was read.</source>
        <translation>{} Blöcke der Datei sind beschädigt; gelesen wurde, was sich auspacken ließ.</translation>
    </message>
    <message>
        <source>Chunks compressed as &quot;{}&quot; cannot be unpacked and were left out.</source>
        <translation>Blöcke, die als „{}“ gepackt sind, lassen sich nicht auspacken und wurden ausgelassen.</translation>
    </message>
    <message>
        <source>Convert them with the program &apos;mcap&apos; to zstd or lz4.</source>
        <translation>Wandeln Sie sie mit dem Programm „mcap“ in zstd oder lz4 um.</translation>
    </message>
    <message>
        <source>The file is cut off or damaged at byte {} of {}; everything before that was read.</source>
        <translation>Die Datei ist bei Byte {} von {} abgeschnitten oder beschädigt; gelesen wurde, was davor steht.</translation>
    </message>
    <message>
        <source>{} of {} messages on {} do not fit their definition and were left out.</source>
        <translation>{} von {} Nachrichten auf {} passen nicht zu ihrer Definition und wurden ausgelassen.</translation>
    </message>
    <message>
        <source>Topic {} of type {} cannot be read: {}.</source>
        <translation>Topic {} vom Typ {} ist nicht lesbar: {}.</translation>
    </message>
    <message>
        <source>{} messages belong to topics that the file does not describe; they were left out.</source>
        <translation>{} Nachrichten gehören zu Topics, die die Datei nicht beschreibt; sie wurden ausgelassen.</translation>
    </message>
    <message>
        <source>The selected topics hold more than {} million numbers; the rest was not read.</source>
        <translation>Die gewählten Topics enthalten mehr als {} Millionen Zahlen; der Rest wurde nicht gelesen.</translation>
    </message>
    <message>
        <source>{} of {} messages cannot be unpacked and were left out.</source>
        <translation>{} von {} Nachrichten lassen sich nicht auspacken und wurden ausgelassen.</translation>
    </message>
    <message>
        <source>The database is damaged ({}) after {} messages; these were read.</source>
        <translation>Die Datenbank ist beschädigt ({}), nach {} Nachrichten; diese wurden gelesen.</translation>
    </message>
    <message>
        <source>The recorder was probably killed; &quot;sqlite3 BAG .recover&quot; may find more.</source>
        <translation>Der Rekorder wurde wohl hart beendet; „sqlite3 BAG .recover“ findet vielleicht mehr.</translation>
    </message>
    <message>
        <source>The compressed file is cut off or damaged; what could be unpacked was read.</source>
        <translation>Die gepackte Datei ist abgeschnitten oder beschädigt; gelesen wurde, was sich auspacken ließ.</translation>
    </message>
    <message>
        <source>metadata.yaml names no file that is there; the folder&apos;s own bag files were read.</source>
        <translation>metadata.yaml nennt keine Datei, die da ist; gelesen wurden die Bag-Dateien des Ordners.</translation>
    </message>
    <message>
        <source>The folder has no metadata.yaml; its bag files were read.</source>
        <translation>Der Ordner hat keine metadata.yaml; seine Bag-Dateien wurden gelesen.</translation>
    </message>
    <message>
        <source>Labels are free, contact or ignore.</source>
        <translation>Markierungen heißen free, contact oder ignore.</translation>
    </message>
    <message>
        <source>The last line ends in the middle and was left out.</source>
        <translation>Die letzte Zeile endet mittendrin und wurde ausgelassen.</translation>
    </message>
    <message>
        <source>The reported {} velocities lag the positions by {:.0f} ms; velocities and accelerations are taken from the positions.</source>
        <translation>Die gemeldeten Geschwindigkeiten ({}) hinken den Positionen {:.0f} ms nach; Geschwindigkeiten und Beschleunigungen stammen deshalb aus den Positionen.</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>The recording has the sensor&apos;s orientation but not its position, so the acceleration of its origin is unknown and taken as zero.</source>
        <translation>Die Aufnahme enthält die Ausrichtung des Sensors, aber nicht seinen Ort; die Beschleunigung seines Ursprungs ist deshalb unbekannt und gilt als null.</translation>
    </message>
    <message>
        <source>Record px, py, pz or the joint angles for trustworthy numbers.</source>
        <translation>Nehmen Sie px, py, pz oder die Gelenkwinkel auf, dann sind die Zahlen vertrauenswürdig.</translation>
    </message>
    <message>
        <source>The data had {} gaps.</source>
        <translation>Die Daten hatten {} Lücken.</translation>
    </message>
    <message>
        <source>Check the source.</source>
        <translation>Prüfen Sie die Quelle.</translation>
    </message>
    <message>
        <source>Move the tool without touching anything.</source>
        <translation>Bewegen Sie das Werkzeug, ohne etwas zu berühren.</translation>
    </message>
    <message>
        <source>A number is not finite.</source>
        <translation>Eine Zahl ist nicht endlich.</translation>
    </message>
    <message>
        <source>The mass is {:.6g} kg; it must be above zero.</source>
        <translation>Die Masse ist {:.6g} kg; sie muss größer als null sein.</translation>
    </message>
    <message>
        <source>The inertia tensor is not symmetric.</source>
        <translation>Der Trägheitstensor ist nicht symmetrisch.</translation>
    </message>
    <message>
        <source>The inertia tensor has a principal moment of {:.6g} kg m2; all must be above zero.</source>
        <translation>Der Trägheitstensor hat ein Hauptmoment von {:.6g} kg m²; alle müssen größer als null sein.</translation>
    </message>
    <message>
        <source>The principal moments {:.6g}, {:.6g}, {:.6g} kg m2 violate the triangle inequality: no body has more about one axis than about the other two together.</source>
        <translation>Die Hauptmomente {:.6g}, {:.6g}, {:.6g} kg m² verletzen die Dreiecksungleichung: Kein Körper hat um eine Achse mehr als um die beiden anderen zusammen.</translation>
    </message>
    <message>
        <source>If the file is in millimetres set unit to mm.</source>
        <translation>Wenn die Datei in Millimetern ist, stellen Sie die Einheit auf mm.</translation>
    </message>
    <message>
        <source>Check the unit of the file.</source>
        <translation>Prüfen Sie die Einheit der Datei.</translation>
    </message>
    <message>
        <source>If the file is in metres set unit to m.</source>
        <translation>Wenn die Datei in Metern ist, stellen Sie die Einheit auf m.</translation>
    </message>
    <message>
        <source>If the file is in centimetres set unit to cm.</source>
        <translation>Wenn die Datei in Zentimetern ist, stellen Sie die Einheit auf cm.</translation>
    </message>
    <message>
        <source>Dimensions are in metres.</source>
        <translation>Maße sind in Metern.</translation>
    </message>
    <message>
        <source>{} is {} long.</source>
        <translation>{} ist {} lang.</translation>
    </message>
    <message>
        <source>Recompute the normals in the program that wrote the mesh.</source>
        <translation>Berechnen Sie die Normalen in dem Programm neu, das das Netz geschrieben hat.</translation>
    </message>
    <message>
        <source>Flip the normals in the program that wrote the mesh if this is not wanted.</source>
        <translation>Kehren Sie die Normalen in dem Programm um, das das Netz geschrieben hat, wenn das nicht gewollt ist.</translation>
    </message>
    <message>
        <source>{} is not closed: {} open edges; the holes were covered ({:.1f} % of the surface).</source>
        <translation>{} ist nicht geschlossen: {} offene Kanten; die Löcher wurden zugedeckt ({:.1f} % der Oberfläche).</translation>
    </message>
    <message>
        <source>Export a closed solid, or give a wall thickness if the tool is a thin shell.</source>
        <translation>Exportieren Sie einen geschlossenen Körper, oder geben Sie eine Wandstärke an, wenn das Werkzeug eine dünne Schale ist.</translation>
    </message>
    <message>
        <source>{}: {} edges belong to more than two triangles (parts that touch along an edge).</source>
        <translation>{}: {} Kanten gehören zu mehr als zwei Dreiecken (Teile, die sich entlang einer Kante berühren).</translation>
    </message>
    <message>
        <source>{}: {} triangles have a vertex that is missing or not a number.</source>
        <translation>{}: {} Dreiecke haben eine Ecke, die fehlt oder keine Zahl ist.</translation>
    </message>
    <message>
        <source>They were left out.</source>
        <translation>Sie wurden ausgelassen.</translation>
    </message>
    <message>
        <source>{} has a density of {:.4g} kg/m3.</source>
        <translation>{} hat eine Dichte von {:.4g} kg/m³.</translation>
    </message>
    <message>
        <source>If it is in g/cm3, multiply it by 1000.</source>
        <translation>Wenn sie in g/cm³ ist, nehmen Sie sie mal 1000.</translation>
    </message>
    <message>
        <source>Check it.</source>
        <translation>Prüfen Sie sie.</translation>
    </message>
    <message>
        <source>Read {}.</source>
        <translation>Gelesen: {}.</translation>
    </message>
    <message>
        <source>Blank lines between the rows were skipped.</source>
        <translation>Leerzeilen zwischen den Zeilen wurden übersprungen.</translation>
    </message>
    <message>
        <source>{} unknown columns of {} rows are too many to keep.</source>
        <translation>{} unbekannte Spalten mit {} Zeilen sind zu viele, um sie aufzuheben.</translation>
    </message>
    <message>
        <source>The joint velocities are</source>
        <translation>Die Gelenkgeschwindigkeiten fehlen</translation>
    </message>
    <message>
        <source>The twist is</source>
        <translation>Geschwindigkeiten des Sensors fehlen</translation>
    </message>
    <message>
        <source>The joint angles are</source>
        <translation>Die Gelenkwinkel fehlen</translation>
    </message>
    <message>
        <source>The sensor&apos;s pose is</source>
        <translation>Posen des Sensors fehlen</translation>
    </message>
    <message>
        <source>{} of {} rows lack a value (blank, NaN or infinite) and were left out, the first in column {}.</source>
        <translation>{} von {} Zeilen fehlt ein Wert (leer, NaN oder unendlich); sie wurden ausgelassen, zuerst in Spalte {}.</translation>
    </message>
    <message>
        <source>{}: {}.</source>
        <translation>{}: {}.</translation>
    </message>
    <message>
        <source>this key is not known and has no effect</source>
        <translation>diesen Schlüssel kennt Heft nicht, er bewirkt nichts</translation>
    </message>
    <message>
        <source>{:.6g} m/s2 is not the gravity on earth</source>
        <translation>{:.6g} m/s² ist nicht die Schwerkraft auf der Erde</translation>
    </message>
    <message>
        <source>Mass and centre of mass follow this value; on earth it is 9.76 to 9.83.</source>
        <translation>Masse und Schwerpunkt richten sich danach; auf der Erde sind es 9,76 bis 9,83.</translation>
    </message>
    <message>
        <source>it points up in the robot&apos;s base</source>
        <translation>sie zeigt im Roboter nach oben</translation>
    </message>
    <message>
        <source>That is right only if the robot hangs from the ceiling; otherwise write [0, 0, -9.81].</source>
        <translation>Das stimmt nur, wenn der Roboter an der Decke hängt; sonst schreiben Sie [0, 0, -9.81].</translation>
    </message>
    <message>
        <source>{:.6g} kg is more than any arm carries</source>
        <translation>{:.6g} kg sind mehr, als ein Arm trägt</translation>
    </message>
    <message>
        <source>Give kilograms, not grams.</source>
        <translation>Geben Sie Kilogramm an, nicht Gramm.</translation>
    </message>
    <message>
        <source>no rigid body has these values ({})</source>
        <translation>kein starrer Körper hat diese Werte ({})</translation>
    </message>
    <message>
        <source>Check which point and which axes the inertia refers to; Heft expects it about the centre of mass.</source>
        <translation>Prüfen Sie, auf welchen Punkt und welche Achsen sich die Trägheit bezieht; Heft will sie um den Schwerpunkt.</translation>
    </message>
    <message>
        <source>overlaps marks[{}], which has another label</source>
        <translation>überlappt marks[{}], das anders markiert ist</translation>
    </message>
    <message>
        <source>{} do not fit the positions: factor {:.3g}, correlation {:.2f}.</source>
        <translation>Nicht zu den Positionen passen: {} (Faktor {:.3g}, Korrelation {:.2f}).</translation>
    </message>
    <message>
        <source>Check their unit, order and axes{}.</source>
        <translation>Prüfen Sie Einheit, Reihenfolge und Achsen{}.</translation>
    </message>
    <message>
        <source>{} reaches {:.6g} rad, more than a turn.</source>
        <translation>{} erreicht {:.6g} rad, mehr als eine Umdrehung.</translation>
    </message>
    <message>
        <source>Check that joints are in radians.</source>
        <translation>Prüfen Sie, dass die Gelenke in Radiant sind.</translation>
    </message>
    <message>
        <source>the joint velocities</source>
        <translation>die Gelenkgeschwindigkeiten</translation>
    </message>
    <message>
        <source> (base axes)</source>
        <translation> (Achsen der Roboterbasis)</translation>
    </message>
    <message>
        <source>{} quaternions are not of length 1, at worst by {:.2g}; all were normalised.</source>
        <translation>{} Quaternionen haben nicht die Länge 1, schlimmstenfalls um {:.2g} daneben; alle wurden normiert.</translation>
    </message>
    <message>
        <source>All {} rows hold the same wrench and the same posture.</source>
        <translation>Alle {} Zeilen enthalten dieselbe Kraft und dieselbe Haltung.</translation>
    </message>
    <message>
        <source>Check that the logger received new data; move the arm while recording.</source>
        <translation>Prüfen Sie, dass der Rekorder neue Daten bekam; bewegen Sie den Arm beim Aufnehmen.</translation>
    </message>
    <message>
        <source>The posture never changes while the wrench does.</source>
        <translation>Die Haltung ändert sich nie, die Kraft aber schon.</translation>
    </message>
    <message>
        <source>Check that the robot&apos;s state was logged; with one posture only the weight&apos;s direction is seen.</source>
        <translation>Prüfen Sie, dass der Zustand des Roboters aufgezeichnet wurde; aus nur einer Haltung sieht man nur, wohin das Gewicht zieht.</translation>
    </message>
    <message>
        <source>{} never change while others do.</source>
        <translation>{} ändern sich nie, während andere es tun.</translation>
    </message>
    <message>
        <source>Check that they were logged.</source>
        <translation>Prüfen Sie, dass sie aufgezeichnet wurden.</translation>
    </message>
    <message>
        <source>{} is {} in every row while others change.</source>
        <translation>{} ist in jeder Zeile {}, während andere sich ändern.</translation>
    </message>
    <message>
        <source>Check that it was logged.</source>
        <translation>Prüfen Sie, dass er aufgezeichnet wurde.</translation>
    </message>
    <message>
        <source>{} of the rows repeat the {} of the row before: new values come at about {:.3g} Hz, rows at {:.4g} Hz.</source>
        <translation>{} der Zeilen wiederholen {} der Zeile davor: Neue Werte kommen mit etwa {:.3g} Hz, Zeilen mit {:.4g} Hz.</translation>
    </message>
    <message>
        <source>Log each source at its own rate, or only when it has a new value.</source>
        <translation>Zeichnen Sie jede Quelle mit ihrer eigenen Rate auf, oder nur, wenn sie einen neuen Wert hat.</translation>
    </message>
    <message>
        <source>wrench</source>
        <translation>die Kraft</translation>
    </message>
    <message>
        <source>posture</source>
        <translation>die Haltung</translation>
    </message>
    <message>
        <source>The wrench</source>
        <translation>Die Kraft</translation>
    </message>
    <message>
        <source>The sensor&apos;s data stopped there; mark it as &quot;ignore&quot;.</source>
        <translation>Die Daten des Sensors blieben dort stehen; markieren Sie das als „ignoriert“.</translation>
    </message>
    <message>
        <source>The channel was not measured there, or the sensor was saturated; mark it as &quot;ignore&quot;.</source>
        <translation>Der Kanal wurde dort nicht gemessen, oder der Sensor war am Anschlag; markieren Sie das als „ignoriert“.</translation>
    </message>
    <message>
        <source>{} stays the same from {:.6g} to {:.6g} s ({} rows){}.</source>
        <translation>{} bleibt von {:.6g} bis {:.6g} s gleich ({} Zeilen){}.</translation>
    </message>
    <message>
        <source>, and in {} more segments</source>
        <translation>, und auf {} weiteren Abschnitten</translation>
    </message>
    <message>
        <source>The posture</source>
        <translation>Die Haltung</translation>
    </message>
    <message>
        <source>It jumps afterwards: the robot&apos;s data stopped there; mark it as &quot;ignore&quot;.</source>
        <translation>Danach springt sie: Die Daten des Roboters blieben dort stehen; markieren Sie das als „ignoriert“.</translation>
    </message>
    <message>
        <source>{} jumps by {:.3g} {} within one row{}.</source>
        <translation>{} springt innerhalb einer Zeile um {:.3g} {}{}.</translation>
    </message>
    <message>
        <source>, and {} times more</source>
        <translation>, und {} weitere Male</translation>
    </message>
    <message>
        <source>Mark that place as &quot;ignore&quot; or split the recording there.</source>
        <translation>Markieren Sie die Stelle als „ignoriert“, oder teilen Sie die Aufnahme dort.</translation>
    </message>
    <message>
        <source>The orientation</source>
        <translation>Die Ausrichtung</translation>
    </message>
    <message>
        <source>The position</source>
        <translation>Der Ort</translation>
    </message>
    <message>
        <source>The force starts at {:.2g} N and later spans {:.3g} N: the sensor was probably zeroed with the payload on.</source>
        <translation>Die Kraft beginnt bei {:.2g} N und reicht später über {:.3g} N: Der Sensor wurde wohl mit der Last daran auf null gesetzt.</translation>
    </message>
    <message>
        <source>Torques vary {:.3g} times as much as forces, as if the payload sat {:.3g} m away.</source>
        <translation>Die Momente ändern sich {:.3g}-mal so stark wie die Kräfte, als säße die Last {:.3g} m entfernt.</translation>
    </message>
    <message>
        <source>Check that tx, ty, tz are in N m, not N mm, and forces in N.</source>
        <translation>Prüfen Sie, dass tx, ty, tz in N m sind, nicht N mm, und die Kräfte in N.</translation>
    </message>
    <message>
        <source>{} of {} rows ({}) repeat the time of the row before and were left out.</source>
        <translation>{} von {} Zeilen ({}) wiederholen die Zeit der Zeile davor und wurden ausgelassen.</translation>
    </message>
    <message>
        <source>The time seems to be written with too few digits.</source>
        <translation>Die Zeit ist wohl mit zu wenigen Stellen geschrieben.</translation>
    </message>
    <message>
        <source>The rate would be {:.4g} Hz, more than wrist sensors give.</source>
        <translation>Die Rate wäre {:.4g} Hz, mehr als Handgelenksensoren liefern.</translation>
    </message>
    <message>
        <source>Check that time is in seconds.</source>
        <translation>Prüfen Sie, dass die Zeit in Sekunden ist.</translation>
    </message>
    <message>
        <source>The rate is {:.3g} Hz (median); inertia needs about 100 Hz or more.</source>
        <translation>Die Rate ist {:.3g} Hz (Median); die Trägheit braucht etwa 100 Hz oder mehr.</translation>
    </message>
    <message>
        <source>{} gap in time, together {}; the longest is {} at {:.6g} s, where steps are {} (median).</source>
        <translation>{} Lücke in der Zeit, zusammen {}; die längste ist {} bei {:.6g} s, wo Schritte {} lang sind (Median).</translation>
    </message>
    <message>
        <source>{} gaps in time, together {}; the longest is {} at {:.6g} s, where steps are {} (median).</source>
        <translation>{} Lücken in der Zeit, zusammen {}; die längste ist {} bei {:.6g} s, wo Schritte {} lang sind (Median).</translation>
    </message>
    <message>
        <source>Time steps vary: nine in ten lie between {} and {}, median {} ({:.4g} Hz).</source>
        <translation>Die Zeitschritte schwanken: Neun von zehn liegen zwischen {} und {}, Median {} ({:.4g} Hz).</translation>
    </message>
    <message>
        <source>The recording is resampled on a uniform clock.</source>
        <translation>Die Aufnahme wird auf eine gleichmäßige Uhr umgerechnet.</translation>
    </message>
    <message>
        <source>{} joint(s) are not on the arm&apos;s main chain and are held still: {}</source>
        <translation>{} Gelenk(e) liegen nicht auf der Hauptkette des Arms und werden festgehalten: {}</translation>
    </message>
    <message>
        <source>Recordings need no column for them</source>
        <translation>Aufnahmen brauchen für sie keine Spalte.</translation>
    </message>
    <message>
        <source>the robot has no link</source>
        <translation>Der Roboter hat kein Glied.</translation>
    </message>
    <message>
        <source>this is a {} file, not a URDF</source>
        <translation>Das ist eine {}-Datei, kein URDF.</translation>
    </message>
    <message>
        <source>Convert it to a URDF first</source>
        <translation>Wandeln Sie sie zuerst in ein URDF um.</translation>
    </message>
    <message>
        <source>the root element is &lt;{}&gt;, not &lt;robot&gt;</source>
        <translation>Das oberste Element ist &lt;{}&gt;, nicht &lt;robot&gt;.</translation>
    </message>
    <message>
        <source>Give a URDF</source>
        <translation>Geben Sie ein URDF an.</translation>
    </message>
    <message>
        <source>&lt;{}&gt; is a xacro macro that was not expanded</source>
        <translation>&lt;{}&gt; ist ein xacro-Makro, das nicht aufgelöst wurde.</translation>
    </message>
    <message>
        <source>Run &quot;xacro FILE.urdf.xacro &gt; FILE.urdf&quot; and give its output</source>
        <translation>Rufen Sie „xacro DATEI.urdf.xacro &gt; DATEI.urdf“ auf, und geben Sie dessen Ausgabe an.</translation>
    </message>
    <message>
        <source>&lt;robot&gt; has no name</source>
        <translation>&lt;robot&gt; hat keinen Namen.</translation>
    </message>
    <message>
        <source>Write &lt;robot name=&quot;...&quot;&gt;</source>
        <translation>Schreiben Sie &lt;robot name=&quot;...&quot;&gt;.</translation>
    </message>
    <message>
        <source>URDF version &quot;{}&quot; is not known</source>
        <translation>Die URDF-Version „{}“ ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Version 1.0 is read</source>
        <translation>Gelesen wird Version 1.0.</translation>
    </message>
    <message>
        <source>this {} has no name</source>
        <translation>Dieses {} hat keinen Namen.</translation>
    </message>
    <message>
        <source>{} &quot;{}&quot; is already defined in line {}</source>
        <translation>{} „{}“ ist schon in Zeile {} definiert.</translation>
    </message>
    <message>
        <source>Give each its own name</source>
        <translation>Geben Sie jedem einen eigenen Namen.</translation>
    </message>
    <message>
        <source>{}=&quot;{}&quot; of &lt;{}&gt; is not {}</source>
        <translation>{}=&quot;{}&quot; von &lt;{}&gt; ist nicht {}.</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>eine endliche Zahl</translation>
    </message>
    <message>
        <source>{} finite numbers</source>
        <translation>{} endliche Zahlen</translation>
    </message>
    <message>
        <source>Write a decimal point and separate numbers by blanks</source>
        <translation>Schreiben Sie einen Dezimalpunkt, und trennen Sie Zahlen durch Leerzeichen.</translation>
    </message>
    <message>
        <source>Heft uses only the robot&apos;s motion, so the result is not affected</source>
        <translation>Heft benutzt nur die Bewegung des Roboters, das Ergebnis hängt nicht davon ab.</translation>
    </message>
    <message>
        <source>the inertial of link &quot;{}&quot; lacks its mass or inertia</source>
        <translation>Der Trägheit des Glieds „{}“ fehlt Masse oder Trägheitstensor.</translation>
    </message>
    <message>
        <source>the inertial of link &quot;{}&quot; has a missing or bad number</source>
        <translation>Die Trägheit des Glieds „{}“ hat eine fehlende oder falsche Zahl.</translation>
    </message>
    <message>
        <source>link &quot;{}&quot; has a mass of {} kg</source>
        <translation>Glied „{}“ hat eine Masse von {} kg.</translation>
    </message>
    <message>
        <source>the inertia of link &quot;{}&quot; has a negative principal moment, {:.3g} kg m2</source>
        <translation>Die Trägheit des Glieds „{}“ hat ein negatives Hauptmoment, {:.3g} kg m².</translation>
    </message>
    <message>
        <source>the inertia of link &quot;{}&quot; breaks the triangle inequality: {:.3g} &gt; {:.3g} + {:.3g} kg m2</source>
        <translation>Die Trägheit des Glieds „{}“ verletzt die Dreiecksungleichung: {:.3g} &gt; {:.3g} + {:.3g} kg m².</translation>
    </message>
    <message>
        <source>joint &quot;{}&quot; has the unknown type &quot;{}&quot;</source>
        <translation>Gelenk „{}“ hat die unbekannte Art „{}“.</translation>
    </message>
    <message>
        <source>A URDF knows fixed, revolute, continuous, prismatic, floating and planar</source>
        <translation>Ein URDF kennt fixed, revolute, continuous, prismatic, floating und planar.</translation>
    </message>
    <message>
        <source>joint &quot;{}&quot; is {}, which no column of q can describe</source>
        <translation>Gelenk „{}“ ist {}; das kann keine Spalte von q beschreiben.</translation>
    </message>
    <message>
        <source>It is held at zero</source>
        <translation>Es bleibt auf null.</translation>
    </message>
    <message>
        <source>joint &quot;{}&quot; names no {} link</source>
        <translation>Gelenk „{}“ nennt kein Glied als {}.</translation>
    </message>
    <message>
        <source>Write &lt;{} link=&quot;...&quot;/&gt;</source>
        <translation>Schreiben Sie &lt;{} link=&quot;...&quot;/&gt;.</translation>
    </message>
    <message>
        <source>joint &quot;{}&quot; names link &quot;{}&quot;, which does not exist</source>
        <translation>Gelenk „{}“ nennt das Glied „{}“, das es nicht gibt.</translation>
    </message>
    <message>
        <source>joint &quot;{}&quot; joins link &quot;{}&quot; to itself</source>
        <translation>Gelenk „{}“ verbindet das Glied „{}“ mit sich selbst.</translation>
    </message>
    <message>
        <source>link &quot;{}&quot; has two parents: joints &quot;{}&quot; (line {}) and &quot;{}&quot;</source>
        <translation>Glied „{}“ hat zwei Eltern: die Gelenke „{}“ (Zeile {}) und „{}“.</translation>
    </message>
    <message>
        <source>A URDF is a tree; remove one of the joints</source>
        <translation>Ein URDF ist ein Baum; entfernen Sie eines der Gelenke.</translation>
    </message>
    <message>
        <source>joint &quot;{}&quot; lies {:.4g} m from its parent</source>
        <translation>Gelenk „{}“ liegt {:.4g} m von seinem Vorgänger.</translation>
    </message>
    <message>
        <source>A URDF is in metres; this looks like millimetres</source>
        <translation>Ein URDF ist in Metern; das sieht nach Millimetern aus.</translation>
    </message>
    <message>
        <source>joint &quot;{}&quot; has an rpy of {:.4g} rad</source>
        <translation>Gelenk „{}“ hat ein rpy von {:.4g} rad.</translation>
    </message>
    <message>
        <source>A URDF is in radians; this looks like degrees</source>
        <translation>Ein URDF ist in Radiant; das sieht nach Grad aus.</translation>
    </message>
    <message>
        <source>the axis of joint &quot;{}&quot; has no xyz</source>
        <translation>Die Achse des Gelenks „{}“ hat kein xyz.</translation>
    </message>
    <message>
        <source>Give the direction, for instance xyz=&quot;0 0 1&quot;</source>
        <translation>Geben Sie die Richtung an, zum Beispiel xyz=&quot;0 0 1&quot;.</translation>
    </message>
    <message>
        <source>the axis of joint &quot;{}&quot; is zero</source>
        <translation>Die Achse des Gelenks „{}“ ist null.</translation>
    </message>
    <message>
        <source>the axis of joint &quot;{}&quot; has length {:.4g}</source>
        <translation>Die Achse des Gelenks „{}“ hat die Länge {:.4g}.</translation>
    </message>
    <message>
        <source>It is taken as a direction</source>
        <translation>Sie gilt als Richtung.</translation>
    </message>
    <message>
        <source>{} joint &quot;{}&quot; has no limits</source>
        <translation>{}-Gelenk „{}“ hat keine Grenzen.</translation>
    </message>
    <message>
        <source>Write &lt;limit lower= upper= velocity= effort=/&gt; or type=&quot;continuous&quot;</source>
        <translation>Schreiben Sie &lt;limit lower= upper= velocity= effort=/&gt; oder type=&quot;continuous&quot;.</translation>
    </message>
    <message>
        <source>the limit of joint &quot;{}&quot; has no {}</source>
        <translation>Der Grenze des Gelenks „{}“ fehlt {}.</translation>
    </message>
    <message>
        <source>A URDF demands it</source>
        <translation>Ein URDF verlangt das.</translation>
    </message>
    <message>
        <source>joint &quot;{}&quot; has a velocity limit of {}</source>
        <translation>Gelenk „{}“ hat eine Geschwindigkeitsgrenze von {}.</translation>
    </message>
    <message>
        <source>It is taken as unlimited</source>
        <translation>Es gilt als unbegrenzt.</translation>
    </message>
    <message>
        <source>joint &quot;{}&quot; has no range: lower and upper are 0</source>
        <translation>Gelenk „{}“ hat keinen Bereich: lower und upper sind 0.</translation>
    </message>
    <message>
        <source>joint &quot;{}&quot; has lower {} above upper {}</source>
        <translation>Bei Gelenk „{}“ liegt lower {} über upper {}.</translation>
    </message>
    <message>
        <source>They are taken the other way round</source>
        <translation>Sie werden vertauscht.</translation>
    </message>
    <message>
        <source>joint &quot;{}&quot; may turn from {} to {} rad</source>
        <translation>Gelenk „{}“ darf sich von {} bis {} rad drehen.</translation>
    </message>
    <message>
        <source>no link is the root: the joints form a closed loop</source>
        <translation>Kein Glied ist die Wurzel: Die Gelenke bilden einen geschlossenen Ring.</translation>
    </message>
    <message>
        <source>A URDF is a tree; remove a joint</source>
        <translation>Ein URDF ist ein Baum; entfernen Sie ein Gelenk.</translation>
    </message>
    <message>
        <source>links &quot;{}&quot; and &quot;{}&quot;{} have no parent; a robot has one root</source>
        <translation>Die Glieder „{}“ und „{}“{} haben keine Eltern; ein Roboter hat eine Wurzel.</translation>
    </message>
    <message>
        <source> and {} more</source>
        <translation> und {} weitere</translation>
    </message>
    <message>
        <source>Join them by a (fixed) joint</source>
        <translation>Verbinden Sie sie durch ein (festes) Gelenk.</translation>
    </message>
    <message>
        <source>It is left out</source>
        <translation>Es wird ausgelassen.</translation>
    </message>
    <message>
        <source>the origin of a visual of link &quot;{}&quot; is not three numbers each</source>
        <translation>Der Ursprung eines Bilds von Glied „{}“ besteht nicht aus je drei Zahlen.</translation>
    </message>
    <message>
        <source>The visual is not drawn</source>
        <translation>Es wird nicht gezeichnet.</translation>
    </message>
    <message>
        <source>a visual of link &quot;{}&quot; has no geometry</source>
        <translation>Ein Bild von Glied „{}“ hat keine Form.</translation>
    </message>
    <message>
        <source>It is not drawn</source>
        <translation>Es wird nicht gezeichnet.</translation>
    </message>
    <message>
        <source>link &quot;{}&quot; has a visual of unknown shape &lt;{}&gt;</source>
        <translation>Glied „{}“ hat ein Bild der unbekannten Form &lt;{}&gt;.</translation>
    </message>
    <message>
        <source>It is not drawn; a URDF knows box, cylinder, sphere and mesh</source>
        <translation>Es wird nicht gezeichnet; ein URDF kennt box, cylinder, sphere und mesh.</translation>
    </message>
    <message>
        <source>the {} of link &quot;{}&quot; needs {} positive number(s)</source>
        <translation>Für {} von Glied „{}“ sind {} positive Zahlen nötig.</translation>
    </message>
    <message>
        <source>the scale of a mesh of link &quot;{}&quot; is not three numbers other than 0</source>
        <translation>Der Maßstab eines Netzes von Glied „{}“ besteht nicht aus drei Zahlen ungleich 0.</translation>
    </message>
    <message>
        <source>The mesh is not drawn</source>
        <translation>Das Netz wird nicht gezeichnet.</translation>
    </message>
    <message>
        <source>a mesh of link &quot;{}&quot; has no filename</source>
        <translation>Ein Netz von Glied „{}“ hat keinen Dateinamen.</translation>
    </message>
    <message>
        <source>mesh &quot;{}&quot; of link &quot;{}&quot; is not found</source>
        <translation>Das Netz „{}“ von Glied „{}“ wurde nicht gefunden.</translation>
    </message>
    <message>
        <source>Put the package&apos;s folder above the URDF or name its parent in ROS_PACKAGE_PATH; motion is not affected</source>
        <translation>Legen Sie den Ordner des Pakets über das URDF, oder nennen Sie seinen Oberordner in ROS_PACKAGE_PATH; die Bewegung hängt nicht davon ab.</translation>
    </message>
    <message>
        <source>It is looked for from &quot;{}&quot;; motion is not affected</source>
        <translation>Gesucht wird ab „{}“; die Bewegung hängt nicht davon ab.</translation>
    </message>
    <message>
        <source>a colour of link &quot;{}&quot; is not four numbers</source>
        <translation>Eine Farbe von Glied „{}“ besteht nicht aus vier Zahlen.</translation>
    </message>
    <message>
        <source>Grey is used</source>
        <translation>Grau wird benutzt.</translation>
    </message>
    <message>
        <source>material &quot;{}&quot; of link &quot;{}&quot; is defined nowhere</source>
        <translation>Das Material „{}“ von Glied „{}“ ist nirgends definiert.</translation>
    </message>
    <message>
        <source>Free, but with a different sensor bias or payload.</source>
        <translation>Frei, aber der Nullpunkt des Sensors (oder die Last) ist hier ein anderer.</translation>
    </message>
    <message>
        <source>Free, but {:.2g} kg heavier than where the payload is estimated.</source>
        <translation>Frei, aber {:.2g} kg schwerer als dort, wo die Last bestimmt wird.</translation>
    </message>
    <message>
        <source>Free, but {:.2g} kg lighter than where the payload is estimated.</source>
        <translation>Frei, aber {:.2g} kg leichter als dort, wo die Last bestimmt wird.</translation>
    </message>
    <message>
        <source>{:+.2g} kg at {:.1f} s</source>
        <translation>{:+.2g} kg bei {:.1f} s</translation>
    </message>
    <message>
        <source>at {:.1f} s, or the sensor&apos;s bias moved there</source>
        <translation>bei {:.1f} s, oder der Nullpunkt des Sensors hat sich dort verschoben</translation>
    </message>
    <message>
        <source>The payload changes here, or the sensor&apos;s bias moves: this motion cannot show which.</source>
        <translation>Hier ändert sich die Last, oder der Nullpunkt des Sensors: Diese Bewegung verrät nicht, welches.</translation>
    </message>
    <message>
        <source>The payload grows by {:.2g} kg: something was picked up.</source>
        <translation>Die Last wächst um {:.2g} kg: Etwas wurde aufgenommen.</translation>
    </message>
    <message>
        <source>The payload shrinks by {:.2g} kg: something was put down.</source>
        <translation>Die Last sinkt um {:.2g} kg: Etwas wurde abgelegt.</translation>
    </message>
    <message>
        <source>The payload changes inside the recording ({}); only {} is used, so that two payloads are not mixed.</source>
        <translation>Die Last ändert sich in der Aufnahme ({}); benutzt wird nur {}, damit sich zwei Lasten nicht mischen.</translation>
    </message>
    <message>
        <source>To estimate the other payload, mark its part as free.</source>
        <translation>Um die andere Last zu bestimmen, markieren Sie ihren Teil als frei.</translation>
    </message>
    <message>
        <source>Marked by you.</source>
        <translation>Von Ihnen markiert.</translation>
    </message>
    <message>
        <source>Not marked as free.</source>
        <translation>Nicht als frei markiert.</translation>
    </message>
    <message>
        <source>Not marked as contact.</source>
        <translation>Nicht als Kontakt markiert.</translation>
    </message>
    <message>
        <source>Force not explained by the motion.</source>
        <translation>Ein Stoß, den die Bewegung nicht erklärt.</translation>
    </message>
    <message>
        <source>At rest, and a rigid tool explains the forces.</source>
        <translation>In Ruhe, und ein starres Werkzeug erklärt die Kräfte.</translation>
    </message>
    <message>
        <source>Forces match a rigid tool.</source>
        <translation>Ein starres Werkzeug erklärt hier die Kräfte.</translation>
    </message>
    <message>
        <source>Sensor values frozen: no new data.</source>
        <translation>Die Werte des Sensors stehen hier still: Er schickte nichts Neues.</translation>
    </message>
    <message>
        <source>The shape of link {} is not shown: {}</source>
        <translation>Die Gestalt des Glieds {} wird nicht gezeigt: {}</translation>
    </message>
    <message>
        <source>The numbers do not depend on it.</source>
        <translation>Die Zahlen hängen nicht davon ab.</translation>
    </message>
    <message>
        <source>column {}</source>
        <translation>Spalte {}</translation>
    </message>
    <message>
        <source>{}: this JSON is nested more than {} levels deep.</source>
        <translation>{}: Dieses JSON ist tiefer als {} Ebenen verschachtelt.</translation>
    </message>
    <message>
        <source>{}:{}:{}: this is not valid JSON ({}).</source>
        <translation>{}:{}:{}: Das ist kein gültiges JSON ({}).</translation>
    </message>
    <message>
        <source>{}: this JSON cannot be used ({}).</source>
        <translation>{}: Dieses JSON ist nicht zu gebrauchen ({}).</translation>
    </message>
    <message>
        <source>{}: there is no such file.</source>
        <translation>{}: Diese Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>{} cannot be opened: {}.</source>
        <translation>{} lässt sich nicht öffnen: {}.</translation>
    </message>
    <message>
        <source>{} cannot be read: {}.</source>
        <translation>{} lässt sich nicht lesen: {}.</translation>
    </message>
    <message>
        <source>{} is a folder, not a file.</source>
        <translation>{} ist ein Ordner, keine Datei.</translation>
    </message>
    <message>
        <source>{} has {} MB; at most {} MB can be read.</source>
        <translation>{} hat {} MB; höchstens {} MB können gelesen werden.</translation>
    </message>
    <message>
        <source>{} has more than the {} MB that can be read.</source>
        <translation>{} hat mehr als die {} MB, die gelesen werden können.</translation>
    </message>
    <message>
        <source>The output cannot be written to stdout.</source>
        <translation>Die Ausgabe lässt sich nicht nach stdout schreiben.</translation>
    </message>
    <message>
        <source>{} cannot be written: {}.</source>
        <translation>{} lässt sich nicht schreiben: {}.</translation>
    </message>
    <message>
        <source>A proposed motion needs a speed above zero and at least one second.</source>
        <translation>Eine vorgeschlagene Bewegung braucht ein Tempo über null und mindestens eine Sekunde.</translation>
    </message>
    <message>
        <source>The posture is outside the joints&apos; ranges: no motion can start there.</source>
        <translation>Die Haltung liegt außerhalb der Gelenkbereiche: Von dort kann keine Bewegung beginnen.</translation>
    </message>
    <message>
        <source>The coach has no motion called &quot;{}&quot;.</source>
        <translation>Der Coach kennt keine Bewegung namens „{}“.</translation>
    </message>
    <message>
        <source>Estimating the payload again</source>
        <translation>Die Last wird neu geschätzt</translation>
    </message>
    <message>
        <source>The trim is a fraction of the duration at each end, from 0 to below 0.5, not {}.</source>
        <translation>Der Beschnitt ist ein Anteil der Dauer an jedem Ende, von 0 bis unter 0,5, nicht {}.</translation>
    </message>
    <message>
        <source>Holding the mass inside the shape needs a shape, the method map and the parameters full.</source>
        <translation>Um die Masse in der Form zu halten, braucht es eine Form, das Verfahren map und alle Parameter (full).</translation>
    </message>
    <message>
        <source>Converged: the gradient vanished.</source>
        <translation>Konvergiert: Der Gradient ist verschwunden.</translation>
    </message>
    <message>
        <source>Stopped before the gradient vanished.</source>
        <translation>Angehalten, bevor der Gradient verschwunden war.</translation>
    </message>
    <message>
        <source>Total least squares has no solution here: the smallest singular value belongs to the regressor.</source>
        <translation>Die vollständigen kleinsten Quadrate haben hier keine Lösung: Der kleinste Singulärwert gehört zum Regressor.</translation>
    </message>
    <message>
        <source>Singular value decomposition done.</source>
        <translation>Singulärwertzerlegung ausgeführt.</translation>
    </message>
    <message>
        <source>Learning the sensor&apos;s noise</source>
        <translation>Das Rauschen des Sensors wird gelernt</translation>
    </message>
    <message>
        <source>Standing poses have no segments: each row is a measurement of its own.</source>
        <translation>Stehende Posen haben keine Abschnitte: Jede Zeile ist eine Messung für sich.</translation>
    </message>
    <message>
        <source>This payload cannot exist, so no {} file is written: {}</source>
        <translation>Diese Last kann es nicht geben, darum wird keine {}-Datei geschrieben: {}</translation>
    </message>
    <message>
        <source>The tool centre point is not a pose: its rotation must be orthonormal and right-handed.</source>
        <translation>Der Werkzeugmittelpunkt (TCP) ist keine Pose: Seine Drehung muss orthonormal und rechtshändig sein.</translation>
    </message>
    <message>
        <source>This payload is too small to be written: {}</source>
        <translation>Diese Last ist zu klein, um geschrieben zu werden: {}</translation>
    </message>
    <message>
        <source>{}: {} of the sensor mount must be three numbers.</source>
        <translation>{}: {} der Sensormontage muss aus drei Zahlen bestehen.</translation>
    </message>
    <message>
        <source>The sensor is mounted on {}, which moves against the flange: state its pose on the flange.</source>
        <translation>Der Sensor sitzt an {}, das sich gegen den Flansch bewegt: Geben Sie seine Pose am Flansch an.</translation>
    </message>
    <message>
        <source>{} holds no sensor mount: expected &quot;sensor&quot;: {{&quot;mount&quot;: {{&quot;xyz_m&quot;: [x,y,z], &quot;rpy_rad&quot;: [r,p,y]}}}} as in a setup file.</source>
        <translation>{} enthält keine Sensormontage: Erwartet wird &quot;sensor&quot;: {{&quot;mount&quot;: {{&quot;xyz_m&quot;: [x,y,z], &quot;rpy_rad&quot;: [r,p,y]}}}} wie in einer Aufbaudatei.</translation>
    </message>
    <message>
        <source>the file cannot be opened.</source>
        <translation>die Datei lässt sich nicht öffnen.</translation>
    </message>
    <message>
        <source>Check its name and its permissions.</source>
        <translation>Prüfen Sie Namen und Leserechte.</translation>
    </message>
    <message>
        <source>Give a recording&apos;s file.</source>
        <translation>Geben Sie die Datei einer Aufnahme an.</translation>
    </message>
    <message>
        <source>names of the columns</source>
        <translation>Namen der Spalten</translation>
    </message>
    <message>
        <source>type {}</source>
        <translation>Typ {}</translation>
    </message>
    <message>
        <source>an estimate or a compensated wrench: the tool&apos;s own weight may be taken out of it</source>
        <translation>eine Schätzung oder eine bereinigte Kraft: Das Eigengewicht des Werkzeugs könnte schon abgezogen sein</translation>
    </message>
    <message>
        <source>names of the arm&apos;s joints</source>
        <translation>Namen der Armgelenke</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>a compound type</source>
        <translation>ein zusammengesetzter Typ</translation>
    </message>
    <message>
        <source>lists of different lengths</source>
        <translation>verschieden lange Listen</translation>
    </message>
    <message>
        <source>an array type</source>
        <translation>ein Feldtyp</translation>
    </message>
    <message>
        <source>names of states</source>
        <translation>Namen von Zuständen</translation>
    </message>
    <message>
        <source>no plain numbers</source>
        <translation>keine einfachen Zahlen</translation>
    </message>
    <message>
        <source>{} dimensions</source>
        <translation>{} Dimensionen</translation>
    </message>
    <message>
        <source>this HDF5 file cannot be opened: it is cut off or damaged.</source>
        <translation>diese HDF5-Datei lässt sich nicht öffnen: Sie ist abgeschnitten oder beschädigt.</translation>
    </message>
    <message>
        <source>{} more</source>
        <translation>{} weitere</translation>
    </message>
    <message>
        <source>no dataset of this HDF5 file is a table of numbers: {}.</source>
        <translation>kein Datensatz dieser HDF5-Datei ist eine Zahlentabelle: {}.</translation>
    </message>
    <message>
        <source>Reading was stopped.</source>
        <translation>Das Lesen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>this is a folder, not a recording.</source>
        <translation>das ist ein Ordner, keine Aufnahme.</translation>
    </message>
    <message>
        <source>Give the recording&apos;s file, or the folder of a ROS 2 bag.</source>
        <translation>Geben Sie die Datei der Aufnahme an oder den Ordner eines ROS-2-Bags.</translation>
    </message>
    <message>
        <source>unknown kind of file</source>
        <translation>unbekannte Dateiart</translation>
    </message>
    <message>
        <source>Split it, or record fewer topics.</source>
        <translation>Teilen Sie sie, oder nehmen Sie weniger Topics auf.</translation>
    </message>
    <message>
        <source>it is cut off or damaged before the first message that could be read.</source>
        <translation>sie ist vor der ersten lesbaren Nachricht abgeschnitten oder beschädigt.</translation>
    </message>
    <message>
        <source>Copy it again from where it was recorded.</source>
        <translation>Kopieren Sie sie noch einmal von dort, wo sie aufgenommen wurde.</translation>
    </message>
    <message>
        <source>{} has fewer than two complete samples.</source>
        <translation>{} hat weniger als zwei vollständige Messwerte.</translation>
    </message>
    <message>
        <source>Record again, or choose other columns.</source>
        <translation>Nehmen Sie noch einmal auf, oder wählen Sie andere Spalten.</translation>
    </message>
    <message>
        <source>{:.3f} s (+- {:.3f} s; the motion then explains {:.0f} % of the force)</source>
        <translation>{:.3f} s (± {:.3f} s; die Bewegung erklärt dann {:.0f} % der Kraft)</translation>
    </message>
    <message>
        <source>{} and {} do not overlap in time: {:.3f} to {:.3f} s and {:.3f} to {:.3f} s.</source>
        <translation>{} und {} überschneiden sich zeitlich nicht: {:.3f} bis {:.3f} s und {:.3f} bis {:.3f} s.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; has no {} that Heft can find by name.</source>
        <translation>„{}“ hat kein {}, das Heft am Namen erkennt.</translation>
    </message>
    <message>
        <source>Name its columns one by one, for instance fx=TOPIC:FIELD.</source>
        <translation>Nennen Sie die Spalten einzeln, zum Beispiel fx=TOPIC:FELD.</translation>
    </message>
    <message>
        <source>there is no &quot;{}&quot;, which {} was to be read from.</source>
        <translation>es gibt kein „{}“, aus dem {} gelesen werden sollte.</translation>
    </message>
    <message>
        <source>&apos;heft convert IN --list&apos; shows what there is.</source>
        <translation>„heft convert IN --list“ zeigt, was da ist.</translation>
    </message>
    <message>
        <source>no wrench of a sensor was found.</source>
        <translation>Kraft und Moment eines Sensors wurden nicht gefunden.</translation>
    </message>
    <message>
        <source>of the wrench {} is missing.</source>
        <translation>von Kraft und Moment fehlt {}.</translation>
    </message>
    <message>
        <source>Add its file with --join FILE, or name its columns with --use.</source>
        <translation>Fügen Sie die Datei davon mit --join DATEI hinzu, oder sagen Sie mit --use, in welchen Spalten es steht.</translation>
    </message>
    <message>
        <source>no motion was found: neither joint positions nor a pose of the sensor.</source>
        <translation>es wurde keine Bewegung gefunden: weder Gelenkwinkel noch eine Pose des Sensors.</translation>
    </message>
    <message>
        <source>the columns of the {} come from {} and from {}.</source>
        <translation>die Spalten von {} kommen aus {} und aus {}.</translation>
    </message>
    <message>
        <source>They must share their times.</source>
        <translation>Sie müssen dieselben Zeiten haben.</translation>
    </message>
    <message>
        <source>{} from {} ({})</source>
        <translation>{} aus {} ({})</translation>
    </message>
    <message>
        <source>The {} could also be {}.</source>
        <translation>{} könnte auch {} sein.</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>Choose with --use {}=NAME.</source>
        <translation>Wählen Sie mit --use {}=NAME.</translation>
    </message>
    <message>
        <source>The definition of {} lacks {}.</source>
        <translation>In der Definition von {} fehlt {}.</translation>
    </message>
    <message>
        <source>The definition of {} has an array without an end.</source>
        <translation>In der Definition von {} hat ein Feld kein Ende.</translation>
    </message>
    <message>
        <source>The definition of {} has an array of odd length.</source>
        <translation>In der Definition von {} hat ein Feld eine seltsame Länge.</translation>
    </message>
    <message>
        <source>its encoding is not known</source>
        <translation>ihre Codierung ist nicht bekannt</translation>
    </message>
    <message>
        <source>the file does not define its type</source>
        <translation>die Datei definiert ihren Typ nicht</translation>
    </message>
    <message>
        <source>this database holds no ROS 2 bag ({}).</source>
        <translation>diese Datenbank enthält kein ROS-2-Bag ({}).</translation>
    </message>
    <message>
        <source>this database cannot be opened.</source>
        <translation>diese Datenbank lässt sich nicht öffnen.</translation>
    </message>
    <message>
        <source>It is damaged at its beginning; &quot;sqlite3 BAG .recover&quot; may save its rows.</source>
        <translation>Sie ist am Anfang beschädigt; „sqlite3 BAG .recover“ rettet vielleicht ihre Zeilen.</translation>
    </message>
    <message>
        <source>this folder holds no ROS 2 bag.</source>
        <translation>dieser Ordner enthält kein ROS-2-Bag.</translation>
    </message>
    <message>
        <source>Such a folder has metadata.yaml and .db3 or .mcap files; otherwise give the recording&apos;s file.</source>
        <translation>So ein Ordner hat metadata.yaml und .db3- oder .mcap-Dateien; geben Sie sonst die Datei der Aufnahme an.</translation>
    </message>
    <message>
        <source>The bag is cut off or damaged at byte {} of {}; everything before that was read.</source>
        <translation>Das Bag ist bei Byte {} von {} abgeschnitten oder beschädigt; was davor steht, wurde gelesen.</translation>
    </message>
    <message>
        <source>{} chunks of the bag are damaged; what could be unpacked was read.</source>
        <translation>{} Blöcke des Bags sind beschädigt; was sich entpacken ließ, wurde gelesen.</translation>
    </message>
    <message>
        <source>this is a ROS bag of an old format.</source>
        <translation>das ist ein ROS-Bag in einem alten Format.</translation>
    </message>
    <message>
        <source>no column holds the time.</source>
        <translation>keine Spalte enthält die Zeit.</translation>
    </message>
    <message>
        <source>there is no column &quot;{}&quot; for the time.</source>
        <translation>es gibt keine Spalte „{}“ für die Zeit.</translation>
    </message>
    <message>
        <source>no column of the table holds numbers.</source>
        <translation>keine Spalte der Tabelle enthält Zahlen.</translation>
    </message>
    <message>
        <source>Check the export.</source>
        <translation>Prüfen Sie den Export.</translation>
    </message>
    <message>
        <source>Export fewer columns or a shorter segment.</source>
        <translation>Exportieren Sie weniger Spalten oder ein kürzeres Stück.</translation>
    </message>
    <message>
        <source>Record fewer values, or a shorter segment.</source>
        <translation>Nehmen Sie weniger Werte auf oder ein kürzeres Stück.</translation>
    </message>
    <message>
        <source>no line of the file is a JSON object.</source>
        <translation>keine Zeile der Datei ist ein JSON-Objekt.</translation>
    </message>
    <message>
        <source>Nothing arrives at {}:{}.</source>
        <translation>An {}:{} kommt nichts an.</translation>
    </message>
    <message>
        <source>{}:{} {}. Check the name, the cable and the firewall.</source>
        <translation>{}:{} {}. Prüfen Sie Namen, Kabel und Firewall.</translation>
    </message>
    <message>
        <source>Port {} of {} cannot be opened; does another program listen there?</source>
        <translation>Port {} von {} lässt sich nicht öffnen; lauscht dort ein anderes Programm?</translation>
    </message>
    <message>
        <source>cannot be found</source>
        <translation>ist nicht zu finden</translation>
    </message>
    <message>
        <source>cannot be reached</source>
        <translation>ist nicht zu erreichen</translation>
    </message>
    <message>
        <source>does not answer over HTTP</source>
        <translation>antwortet nicht über HTTP</translation>
    </message>
    <message>
        <source>http://{}:{}{} does not answer as expected (&quot;{}&quot;).</source>
        <translation>http://{}:{}{} antwortet nicht wie erwartet („{}“).</translation>
    </message>
    <message>
        <source>{} Its counts per newton can be given instead: rdt:HOST?cpf=N&amp;cpt=N.</source>
        <translation>{} Seine Zählschritte je Newton können stattdessen angegeben werden: rdt:HOST?cpf=N&amp;cpt=N.</translation>
    </message>
    <message>
        <source>The sensor is set to {} and {}: choose N and N-m on its web page.</source>
        <translation>Der Sensor ist auf {} und {} eingestellt: Wählen Sie auf seiner Webseite N und N-m.</translation>
    </message>
    <message>
        <source>The sensor does not state its counts per newton; give them: rdt:HOST?cpf=N&amp;cpt=N.</source>
        <translation>Der Sensor nennt seine Zählschritte je Newton nicht; geben Sie sie an: rdt:HOST?cpf=N&amp;cpt=N.</translation>
    </message>
    <message>
        <source>replay of {}</source>
        <translation>Wiedergabe von {}</translation>
    </message>
    <message>
        <source>{} has {} joints; live samples have seven at most.</source>
        <translation>{} hat {} Gelenke; live sind höchstens sieben möglich.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; in &quot;{}&quot; is not known.</source>
        <translation>„{}“ in „{}“ ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The virtual arm has seven joints at most.</source>
        <translation>Der virtuelle Arm hat höchstens sieben Gelenke.</translation>
    </message>
    <message>
        <source>{}:{} cannot be reached over WebSocket ({}). Does the bridge run, and is the port open?</source>
        <translation>{}:{} ist über WebSocket nicht zu erreichen ({}). Läuft die Bridge, und ist der Port offen?</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>contains no triangle</source>
        <translation>enthält kein Dreieck</translation>
    </message>
    <message>
        <source>nests nodes deeper than {}</source>
        <translation>verschachtelt Knoten tiefer als {}</translation>
    </message>
    <message>
        <source>places a mesh by a singular transformation</source>
        <translation>setzt ein Netz mit einer singulären Transformation ein</translation>
    </message>
    <message>
        <source>contains a vertex that is not a finite number</source>
        <translation>enthält einen Punkt, der keine endliche Zahl ist</translation>
    </message>
    <message>
        <source>has a triangle that names a vertex which does not exist</source>
        <translation>hat ein Dreieck mit einem Punkt, den es nicht gibt</translation>
    </message>
    <message>
        <source>{}: There is no such mesh file.</source>
        <translation>{}: Diese Netz-Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>{}: The mesh file is empty or cannot be read.</source>
        <translation>{}: Die Netz-Datei ist leer oder lässt sich nicht lesen.</translation>
    </message>
    <message>
        <source>{}: The mesh file has {} MB; at most {} MB are read. Decimate it first.</source>
        <translation>{}: Die Netz-Datei hat {} MB; höchstens {} MB werden gelesen. Vereinfachen Sie das Netz zuerst.</translation>
    </message>
    <message>
        <source>{}: Meshes of kind &quot;{}&quot; are not known. Use .stl, .obj, .ply, .dae or .glb.</source>
        <translation>{}: Netze der Art „{}“ sind nicht bekannt. Nehmen Sie .stl, .obj, .ply, .dae oder .glb.</translation>
    </message>
    <message>
        <source>{}: The mesh cannot be read: {}</source>
        <translation>{}: Das Netz lässt sich nicht lesen: {}</translation>
    </message>
    <message>
        <source>it is incomplete.</source>
        <translation>es ist unvollständig.</translation>
    </message>
    <message>
        <source>{}: The mesh {}.</source>
        <translation>{}: Das Netz {}.</translation>
    </message>
    <message>
        <source>The recording names no robot.</source>
        <translation>Die Aufnahme nennt keinen Roboter.</translation>
    </message>
    <message>
        <source>The recording has no rows.</source>
        <translation>Die Aufnahme hat keine Zeilen.</translation>
    </message>
    <message>
        <source>Savitzky-Golay needs an order of at least 2 and a window above the order, not order {} and window {}.</source>
        <translation>Savitzky-Golay braucht mindestens Ordnung 2 und ein Fenster über der Ordnung, nicht Ordnung {} und Fenster {}.</translation>
    </message>
    <message>
        <source>The low-pass cutoff cannot be {} Hz; give a frequency above zero.</source>
        <translation>Die Grenze des Tiefpasses kann nicht {} Hz sein; geben Sie eine Frequenz über null an.</translation>
    </message>
    <message>
        <source>must be a list of {} numbers</source>
        <translation>muss eine Liste aus {} Zahlen sein</translation>
    </message>
    <message>
        <source>holds a number that is not finite</source>
        <translation>enthält eine Zahl, die nicht endlich ist</translation>
    </message>
    <message>
        <source>{}: a payload must be a JSON object.</source>
        <translation>{}: Eine Last muss ein JSON-Objekt sein.</translation>
    </message>
    <message>
        <source>{}: mass_kg must be a number in kilograms.</source>
        <translation>{}: mass_kg muss eine Zahl in Kilogramm sein.</translation>
    </message>
    <message>
        <source>{}: mass_kg is {}; a mass must be above zero.</source>
        <translation>{}: mass_kg ist {}; eine Masse muss über null liegen.</translation>
    </message>
    <message>
        <source>{}: com_m {} in metres.</source>
        <translation>{}: com_m {}, in Metern.</translation>
    </message>
    <message>
        <source>{}: inertia_com_kgm2 must be three rows of three numbers in kg m2.</source>
        <translation>{}: inertia_com_kgm2 muss aus drei Zeilen zu drei Zahlen in kg m2 bestehen.</translation>
    </message>
    <message>
        <source>{}: inertia_com_kgm2[{}] {} in kg m2.</source>
        <translation>{}: inertia_com_kgm2[{}] {}, in kg m2.</translation>
    </message>
    <message>
        <source>{}: inertia_com_kgm2 must be symmetric.</source>
        <translation>{}: inertia_com_kgm2 muss symmetrisch sein.</translation>
    </message>
    <message>
        <source>{}: {} is missing.</source>
        <translation>{}: {} fehlt.</translation>
    </message>
    <message>
        <source>{:.3g} m</source>
        <translation>{:.3g} m</translation>
    </message>
    <message>
        <source>{:.3g} mm</source>
        <translation>{:.3g} mm</translation>
    </message>
    <message>
        <source>{} has no area: all of its triangles are lines.</source>
        <translation>{} hat keine Fläche: Alle Dreiecke sind Striche.</translation>
    </message>
    <message>
        <source>{} is too thin to have a volume.</source>
        <translation>{} ist zu dünn, um ein Volumen zu haben.</translation>
    </message>
    <message>
        <source>{} has no triangles: a shape needs a surface.</source>
        <translation>{} hat keine Dreiecke: Eine Form braucht eine Oberfläche.</translation>
    </message>
    <message>
        <source>{} encloses no volume ({} open edges): export a closed solid, or give its wall thickness so that it counts as a thin shell.</source>
        <translation>{} umschließt kein Volumen ({} offene Kanten): Exportieren Sie einen geschlossenen Körper, oder geben Sie die Wandstärke an, dann gilt es als dünne Schale.</translation>
    </message>
    <message>
        <source>{} is so flat, or cuts through itself so badly, that its inside cannot be determined: export a clean solid, or give its wall thickness.</source>
        <translation>{} ist so flach oder durchdringt sich selbst so sehr, dass das Innere nicht zu erkennen ist: Exportieren Sie einen sauberen Körper, oder geben Sie die Wandstärke an.</translation>
    </message>
    <message>
        <source>The mesh {}</source>
        <translation>Das Netz {}</translation>
    </message>
    <message>
        <source>The {} (body {})</source>
        <translation>{} (Körper {})</translation>
    </message>
    <message>
        <source>The {}</source>
        <translation>{}</translation>
    </message>
    <message>
        <source>The bodies with a known mass or density weigh {:.4g} kg, more than the total of {:.4g} kg.</source>
        <translation>Die Körper mit bekannter Masse oder Dichte wiegen {:.4g} kg, mehr als die {:.4g} kg insgesamt.</translation>
    </message>
    <message>
        <source>{}: &apos;{}&apos; is not a number.</source>
        <translation>{}: „{}“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>the pose has a component that is not a number.</source>
        <translation>die Pose hat einen Bestandteil, der keine Zahl ist.</translation>
    </message>
    <message>
        <source>the mesh needs a file.</source>
        <translation>das Netz braucht eine Datei.</translation>
    </message>
    <message>
        <source>the unit of the mesh must be a positive number of metres, not {}.</source>
        <translation>die Einheit des Netzes muss eine positive Zahl in Metern sein, nicht {}.</translation>
    </message>
    <message>
        <source>{} ({}) must be a positive (or zero) number of metres, not {}.</source>
        <translation>{} ({}) muss eine positive Zahl in Metern (oder null) sein, nicht {}.</translation>
    </message>
    <message>
        <source>{} ({}) must be a positive number of metres, not {}.</source>
        <translation>{} ({}) muss eine positive Zahl in Metern sein, nicht {}.</translation>
    </message>
    <message>
        <source>the outer radius of a tube (tube:outer,inner,height) must be larger than the inner one, but {} m and {} m are given.</source>
        <translation>der äußere Radius eines Rohrs (tube:outer,inner,height) muss größer sein als der innere, angegeben sind aber {} m und {} m.</translation>
    </message>
    <message>
        <source>the wall must be a positive number of metres, not {}.</source>
        <translation>die Wand muss eine positive Zahl in Metern sein, nicht {}.</translation>
    </message>
    <message>
        <source>a wall of {} m leaves no hollow: it must be thinner than {:.4g} m, or left out for a solid {}.</source>
        <translation>eine Wand von {} m lässt keinen Hohlraum: Sie muss dünner sein als {:.4g} m; lassen Sie sie weg, wenn der Körper massiv ist ({}).</translation>
    </message>
    <message>
        <source>a wall of {} m is too thin for this {}: at least {:.2g} m are expected.</source>
        <translation>eine Wand von {} m ist zu dünn für diese Form ({}): Mindestens {:.2g} m werden erwartet.</translation>
    </message>
    <message>
        <source>give the mass or the density, not both.</source>
        <translation>geben Sie Masse oder Dichte an, nicht beides.</translation>
    </message>
    <message>
        <source>mass must be a positive number of kg, not {}.</source>
        <translation>die Masse muss eine positive Zahl in kg sein, nicht {}.</translation>
    </message>
    <message>
        <source>density must be a positive number of kg/m3, not {}.</source>
        <translation>die Dichte muss eine positive Zahl in kg/m3 sein, nicht {}.</translation>
    </message>
    <message>
        <source>{}.{} must be a number or null.</source>
        <translation>{}.{} muss eine Zahl oder null sein.</translation>
    </message>
    <message>
        <source>{}.{} must be a list of three numbers.</source>
        <translation>{}.{} muss eine Liste aus drei Zahlen sein.</translation>
    </message>
    <message>
        <source>{} must be an object with a kind.</source>
        <translation>{} muss ein Objekt mit kind sein.</translation>
    </message>
    <message>
        <source>{}.kind must be one of {}.</source>
        <translation>{}.kind muss eines von {} sein.</translation>
    </message>
    <message>
        <source>{}.kind must be one of {}, not {}.</source>
        <translation>{}.kind muss eines von {} sein, nicht {}.</translation>
    </message>
    <message>
        <source>{}.file must name the mesh file.</source>
        <translation>{}.file muss die Netz-Datei nennen.</translation>
    </message>
    <message>
        <source>{}.unit must be &quot;m&quot;, &quot;cm&quot;, &quot;mm&quot; or &quot;in&quot;, not {}.</source>
        <translation>{}.unit muss &quot;m&quot;, &quot;cm&quot;, &quot;mm&quot; oder &quot;in&quot; sein, nicht {}.</translation>
    </message>
    <message>
        <source>{}.dims_m must be a list of numbers in metres: {}.</source>
        <translation>{}.dims_m muss eine Liste von Zahlen in Metern sein: {}.</translation>
    </message>
    <message>
        <source>box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>tube</source>
        <translation>Rohr</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>capsule</source>
        <translation>Kapsel</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>{}: certainty must be &quot;rough&quot;, &quot;good&quot; or &quot;exact&quot;, not {}.</source>
        <translation>{}: certainty muss &quot;rough&quot;, &quot;good&quot; oder &quot;exact&quot; sein, nicht {}.</translation>
    </message>
    <message>
        <source>The shape has no bodies.</source>
        <translation>Die Form hat keine Körper.</translation>
    </message>
    <message>
        <source>Shape {}: {}</source>
        <translation>Form {}: {}</translation>
    </message>
    <message>
        <source>Shape body {} ({}): {}</source>
        <translation>Körper {} der Form ({}): {}</translation>
    </message>
    <message>
        <source>The shape&apos;s total mass must be a positive number of kg, not {}.</source>
        <translation>Die Gesamtmasse der Form muss eine positive Zahl in kg sein, nicht {}.</translation>
    </message>
    <message>
        <source>The bodies of the shape weigh {:.4g} kg, which does not fit their total of {:.4g} kg.</source>
        <translation>Die Körper der Form wiegen {:.4g} kg, das passt nicht zu ihrer Gesamtmasse von {:.4g} kg.</translation>
    </message>
    <message>
        <source>{}: a shape is an object with the key &quot;bodies&quot;.</source>
        <translation>{}: Eine Form ist ein Objekt mit dem Schlüssel &quot;bodies&quot;.</translation>
    </message>
    <message>
        <source>{}: &quot;bodies&quot; must be a list with at least one body.</source>
        <translation>{}: &quot;bodies&quot; muss eine Liste mit mindestens einem Körper sein.</translation>
    </message>
    <message>
        <source>No robot is named; with seven joints it is taken to be a Franka Panda, with the sensor at its flange.</source>
        <translation>Es ist kein Roboter genannt; bei sieben Gelenken wird ein Franka Panda angenommen, mit dem Sensor am Flansch.</translation>
    </message>
    <message>
        <source>there are {} joints but no robot is named.</source>
        <translation>es gibt {} Gelenke, aber es ist kein Roboter genannt.</translation>
    </message>
    <message>
        <source>The mark &quot;{}&quot; from {} to {} s lies outside the recording, which runs from {} to {} s.</source>
        <translation>Die Markierung „{}“ von {} bis {} s liegt außerhalb der Aufnahme, die von {} bis {} s reicht.</translation>
    </message>
    <message>
        <source>Marks are on the clock of the column time.</source>
        <translation>Markierungen gehen nach der Uhr der Spalte time.</translation>
    </message>
    <message>
        <source>column &quot;{}&quot; is not in SI units.</source>
        <translation>Spalte „{}“ ist nicht in SI-Einheiten.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; as {}</source>
        <translation>„{}“ als {}</translation>
    </message>
    <message>
        <source>Rename or delete one of them.</source>
        <translation>Benennen Sie eine davon um, oder löschen Sie sie.</translation>
    </message>
    <message>
        <source>there is no motion: neither joint positions q1..q7 nor the sensor&apos;s pose px, py, pz, qx, qy, qz, qw (qx, qy, qz, qw alone will do)</source>
        <translation>es gibt keine Bewegung: weder Gelenkwinkel q1..q7 noch die Pose des Sensors px, py, pz, qx, qy, qz, qw (qx, qy, qz, qw allein genügen)</translation>
    </message>
    <message>
        <source>column {} is missing</source>
        <translation>Spalte {} fehlt</translation>
    </message>
    <message>
        <source>columns {} are missing</source>
        <translation>Spalten {} fehlen</translation>
    </message>
    <message>
        <source>, and </source>
        <translation>, und </translation>
    </message>
    <message>
        <source>Add or rename columns; the header has: {}{}.</source>
        <translation>Ergänzen Sie Spalten, oder benennen Sie sie um; die Kopfzeile hat: {}{}.</translation>
    </message>
    <message>
        <source>(no name)</source>
        <translation>(ohne Namen)</translation>
    </message>
    <message>
        <source>Split the recording, or keep fewer columns and a lower rate.</source>
        <translation>Teilen Sie die Aufnahme, oder behalten Sie weniger Spalten und eine kleinere Rate.</translation>
    </message>
    <message>
        <source>there is a header but no row of data below it.</source>
        <translation>es gibt eine Kopfzeile, aber keine Daten darunter.</translation>
    </message>
    <message>
        <source>Record again, or check the export.</source>
        <translation>Nehmen Sie noch einmal auf, oder prüfen Sie den Export.</translation>
    </message>
    <message>
        <source>values are missing or not finite in {} of {} rows, first in column {}.</source>
        <translation>in {} von {} Zeilen fehlen Werte oder sind nicht endlich, zuerst in Spalte {}.</translation>
    </message>
    <message>
        <source>Merge streams of different rates onto one clock, or delete the rows without values.</source>
        <translation>Bringen Sie Datenströme verschiedener Raten auf eine Uhr, oder löschen Sie die Zeilen ohne Werte.</translation>
    </message>
    <message>
        <source>this is a device, not a recording.</source>
        <translation>das ist ein Gerät, keine Aufnahme.</translation>
    </message>
    <message>
        <source>Give a CSV file or a pipe.</source>
        <translation>Geben Sie eine CSV-Datei oder eine Pipe an.</translation>
    </message>
    <message>
        <source>Give the CSV file in it.</source>
        <translation>Geben Sie die CSV-Datei darin an.</translation>
    </message>
    <message>
        <source>the file has {} MB; recordings of up to {} MB are read.</source>
        <translation>die Datei hat {} MB; Aufnahmen bis {} MB werden gelesen.</translation>
    </message>
    <message>
        <source>Split it, or keep fewer columns and a lower rate.</source>
        <translation>Teilen Sie sie, oder behalten Sie weniger Spalten und eine kleinere Rate.</translation>
    </message>
    <message>
        <source>this is {}, not CSV.</source>
        <translation>das ist {}, kein CSV.</translation>
    </message>
    <message>
        <source>Correct or delete that row.</source>
        <translation>Berichtigen oder löschen Sie diese Zeile.</translation>
    </message>
    <message>
        <source>Write decimal points instead of decimal commas.</source>
        <translation>Schreiben Sie Dezimalpunkte statt Dezimalkommas.</translation>
    </message>
    <message>
        <source>Write the number alone, in SI units.</source>
        <translation>Schreiben Sie die Zahl allein, in SI-Einheiten.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; in column {} is not a number.</source>
        <translation>„{}“ in Spalte {} ist keine Zahl.</translation>
    </message>
    <message>
        <source>this row has {} cells but the header names {} columns.</source>
        <translation>diese Zeile hat {} Zellen, aber die Kopfzeile nennt {} Spalten.</translation>
    </message>
    <message>
        <source>Complete or delete the row.</source>
        <translation>Vervollständigen oder löschen Sie die Zeile.</translation>
    </message>
    <message>
        <source>Give every column a name in the header, or delete the row.</source>
        <translation>Geben Sie in der Kopfzeile jeder Spalte einen Namen, oder löschen Sie die Zeile.</translation>
    </message>
    <message>
        <source>If these are decimal commas, write decimal points, or separate the columns by semicolons and write points.</source>
        <translation>Wenn das Dezimalkommas sind, schreiben Sie Dezimalpunkte, oder trennen Sie die Spalten mit Semikolons und schreiben Sie Punkte.</translation>
    </message>
    <message>
        <source>the file is empty.</source>
        <translation>die Datei ist leer.</translation>
    </message>
    <message>
        <source>this is a binary or damaged file (byte {} is zero), not CSV.</source>
        <translation>das ist eine binäre oder beschädigte Datei (Byte {} ist null), kein CSV.</translation>
    </message>
    <message>
        <source>Export the recording as CSV text.</source>
        <translation>Exportieren Sie die Aufnahme als CSV-Text.</translation>
    </message>
    <message>
        <source>the file holds nothing but blank lines.</source>
        <translation>die Datei enthält nur leere Zeilen.</translation>
    </message>
    <message>
        <source>the header has more than {} columns.</source>
        <translation>die Kopfzeile hat mehr als {} Spalten.</translation>
    </message>
    <message>
        <source>Put a header above the numbers, for instance time,q1,q2,q3,q4,q5,q6,q7,fx,fy,fz,tx,ty,tz.</source>
        <translation>Schreiben Sie über die Zahlen eine Kopfzeile, zum Beispiel time,q1,q2,q3,q4,q5,q6,q7,fx,fy,fz,tx,ty,tz.</translation>
    </message>
    <message>
        <source>a setup file must be a JSON object {{...}}</source>
        <translation>eine Aufbaudatei muss ein JSON-Objekt {{...}} sein</translation>
    </message>
    <message>
        <source>See the keys in the manual.</source>
        <translation>Die Schlüssel stehen im Handbuch.</translation>
    </message>
    <message>
        <source>must be a text, not {}</source>
        <translation>muss ein Text sein, nicht {}</translation>
    </message>
    <message>
        <source>must be three numbers [{}], not {}</source>
        <translation>muss aus drei Zahlen bestehen [{}], nicht {}</translation>
    </message>
    <message>
        <source>must be finite</source>
        <translation>muss endlich sein</translation>
    </message>
    <message>
        <source>Write &quot;panda&quot;, the path of a URDF, or null.</source>
        <translation>Schreiben Sie &quot;panda&quot;, den Pfad eines URDF oder null.</translation>
    </message>
    <message>
        <source>Expand it to a URDF first: xacro in.xacro &gt; out.urdf.</source>
        <translation>Wandeln Sie sie zuerst in ein URDF um: xacro in.xacro &gt; out.urdf.</translation>
    </message>
    <message>
        <source>must be &quot;motion&quot; or &quot;poses&quot;, not {}</source>
        <translation>muss &quot;motion&quot; oder &quot;poses&quot; sein, nicht {}</translation>
    </message>
    <message>
        <source>must be an object, not {}</source>
        <translation>muss ein Objekt sein, nicht {}</translation>
    </message>
    <message>
        <source>must be &quot;sensor_on_payload&quot; or &quot;payload_on_sensor&quot;, not {}</source>
        <translation>muss &quot;sensor_on_payload&quot; oder &quot;payload_on_sensor&quot; sein, nicht {}</translation>
    </message>
    <message>
        <source>At rest, a wrench of the sensor on the payload points up.</source>
        <translation>In Ruhe zeigt die Kraft des Sensors auf die Last nach oben.</translation>
    </message>
    <message>
        <source>the sensor cannot sit {:.6g} m from its link</source>
        <translation>der Sensor kann nicht {:.6g} m von seinem Glied entfernt sitzen</translation>
    </message>
    <message>
        <source>Give metres, not millimetres.</source>
        <translation>Geben Sie Meter an, nicht Millimeter.</translation>
    </message>
    <message>
        <source>an angle of {:.6g} rad is more than a turn</source>
        <translation>ein Winkel von {:.6g} rad ist mehr als eine Umdrehung</translation>
    </message>
    <message>
        <source>Give radians, not degrees.</source>
        <translation>Geben Sie Radiant an, nicht Grad.</translation>
    </message>
    <message>
        <source>Give m/s2; on earth about [0, 0, -9.81].</source>
        <translation>Geben Sie m/s2 an; auf der Erde etwa [0, 0, -9.81].</translation>
    </message>
    <message>
        <source>must be a list, not {}</source>
        <translation>muss eine Liste sein, nicht {}</translation>
    </message>
    <message>
        <source>Write {{&quot;from_s&quot;: 1.5, &quot;to_s&quot;: 3, &quot;label&quot;: &quot;contact&quot;}}.</source>
        <translation>Schreiben Sie {{&quot;from_s&quot;: 1.5, &quot;to_s&quot;: 3, &quot;label&quot;: &quot;contact&quot;}}.</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>must be a time [s], not {}</source>
        <translation>muss eine Zeit [s] sein, nicht {}</translation>
    </message>
    <message>
        <source>ends at {} s, before it begins at {} s</source>
        <translation>endet bei {} s, bevor sie bei {} s beginnt</translation>
    </message>
    <message>
        <source>Swap from_s and to_s.</source>
        <translation>Vertauschen Sie from_s und to_s.</translation>
    </message>
    <message>
        <source>must be &quot;free&quot;, &quot;contact&quot; or &quot;ignore&quot;, not {}</source>
        <translation>muss &quot;free&quot;, &quot;contact&quot; oder &quot;ignore&quot; sein, nicht {}</translation>
    </message>
    <message>
        <source>{} {} ({:.4g} times the change of the positions).</source>
        <translation>{} {} (das {:.4g}-Fache der Änderung der Positionen).</translation>
    </message>
    <message>
        <source>are in degrees per second</source>
        <translation>sind in Grad pro Sekunde</translation>
    </message>
    <message>
        <source>Convert them to rad/s.</source>
        <translation>Rechnen Sie sie in rad/s um.</translation>
    </message>
    <message>
        <source>do not fit: the angles are in degrees</source>
        <translation>passen nicht: Die Winkel sind in Grad</translation>
    </message>
    <message>
        <source>Convert the angles to rad.</source>
        <translation>Rechnen Sie die Winkel in rad um.</translation>
    </message>
    <message>
        <source>do not fit: time is in milliseconds</source>
        <translation>passen nicht: Die Zeit ist in Millisekunden</translation>
    </message>
    <message>
        <source>are in mm/s, or time is in milliseconds</source>
        <translation>sind in mm/s, oder die Zeit ist in Millisekunden</translation>
    </message>
    <message>
        <source>Convert all columns to SI units.</source>
        <translation>Rechnen Sie alle Spalten in SI-Einheiten um.</translation>
    </message>
    <message>
        <source>do not fit: the positions are in millimetres</source>
        <translation>passen nicht: Die Positionen sind in Millimetern</translation>
    </message>
    <message>
        <source> (base axes, at the sensor&apos;s origin)</source>
        <translation> (Achsen des Sockels, am Ursprung des Sensors)</translation>
    </message>
    <message>
        <source>the quaternion ({:.4g}, {:.4g}, {:.4g}, {:.4g}) has length {:.4g} instead of 1.</source>
        <translation>das Quaternion ({:.4g}, {:.4g}, {:.4g}, {:.4g}) hat die Länge {:.4g} statt 1.</translation>
    </message>
    <message>
        <source>Delete the rows in which the robot sent no pose yet.</source>
        <translation>Löschen Sie die Zeilen, in denen der Roboter noch keine Pose gesendet hat.</translation>
    </message>
    <message>
        <source>Check that the columns qx, qy, qz, qw hold a unit quaternion.</source>
        <translation>Prüfen Sie, ob in den Spalten qx, qy, qz, qw ein Einheitsquaternion steht.</translation>
    </message>
    <message>
        <source>rad (about)</source>
        <translation>rad (ungefähr)</translation>
    </message>
    <message>
        <source>{:.4g} ms</source>
        <translation>{:.4g} ms</translation>
    </message>
    <message>
        <source>{:.4g} s</source>
        <translation>{:.4g} s</translation>
    </message>
    <message>
        <source>time stays at {} s in all {} rows.</source>
        <translation>die Zeit bleibt bei {} s stehen, in allen {} Zeilen.</translation>
    </message>
    <message>
        <source>The recording cannot be written: {} has {} rows but time has {}.</source>
        <translation>Die Aufnahme lässt sich nicht schreiben: {} hat {} Zeilen, die Zeit hat {}.</translation>
    </message>
    <message>
        <source>The recording cannot be written: {} holds values that are not finite.</source>
        <translation>Die Aufnahme lässt sich nicht schreiben: {} enthält Werte, die nicht endlich sind.</translation>
    </message>
    <message>
        <source>The recording cannot be written: it has no rows.</source>
        <translation>Die Aufnahme lässt sich nicht schreiben: Sie hat keine Zeilen.</translation>
    </message>
    <message>
        <source>The recording cannot be written: it has {} labels for {} rows.</source>
        <translation>Die Aufnahme lässt sich nicht schreiben: Sie hat {} Kennzeichen für {} Zeilen.</translation>
    </message>
    <message>
        <source>The recording cannot be written: column {} has {} cells for {} rows.</source>
        <translation>Die Aufnahme lässt sich nicht schreiben: Spalte {} hat {} Zellen für {} Zeilen.</translation>
    </message>
    <message>
        <source>{} cannot be written: a text in it, perhaps the robot&apos;s path, is not valid UTF-8.</source>
        <translation>{} lässt sich nicht schreiben: Ein Text darin, vielleicht der Pfad des Roboters, ist kein gültiges UTF-8.</translation>
    </message>
    <message>
        <source>Robot &quot;{}&quot; has no joint that moves.</source>
        <translation>Der Roboter „{}“ hat kein bewegliches Gelenk.</translation>
    </message>
    <message>
        <source>Give an arm&apos;s URDF.</source>
        <translation>Geben Sie das URDF eines Arms an.</translation>
    </message>
    <message>
        <source>{} more error(s) in this file.</source>
        <translation>{} weitere Fehler in dieser Datei.</translation>
    </message>
    <message>
        <source>The URDF cannot be read.</source>
        <translation>Das URDF lässt sich nicht lesen.</translation>
    </message>
    <message>
        <source>{} is a binary file, not XML.</source>
        <translation>{} ist eine binäre Datei, kein XML.</translation>
    </message>
    <message>
        <source>{}:{}:{}: &lt;{}&gt; is never closed; the file may be cut off.</source>
        <translation>{}:{}:{}: &lt;{}&gt; wird nie geschlossen; vielleicht ist die Datei abgeschnitten.</translation>
    </message>
    <message>
        <source>{} contains no XML element.</source>
        <translation>{} enthält kein XML-Element.</translation>
    </message>
    <message>
        <source>this {} is never closed.</source>
        <translation>hier wird etwas nie geschlossen ({}).</translation>
    </message>
    <message>
        <source>this DOCTYPE is never closed.</source>
        <translation>diese DOCTYPE-Angabe wird nie geschlossen.</translation>
    </message>
    <message>
        <source>comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>CDATA block</source>
        <translation>CDATA-Block</translation>
    </message>
    <message>
        <source>processing instruction</source>
        <translation>Verarbeitungsanweisung</translation>
    </message>
    <message>
        <source>this closing tag has no opening one.</source>
        <translation>dieses schließende Tag hat kein öffnendes.</translation>
    </message>
    <message>
        <source>this closing tag does not match &lt;{}&gt; of line {}.</source>
        <translation>dieses schließende Tag passt nicht zu &lt;{}&gt; in Zeile {}.</translation>
    </message>
    <message>
        <source>&apos;&gt;&apos; is missing after a closing tag&apos;s name.</source>
        <translation>nach dem Namen eines schließenden Tags fehlt „&gt;“.</translation>
    </message>
    <message>
        <source>there is a second root element; an XML file has one.</source>
        <translation>es gibt ein zweites Wurzelelement; eine XML-Datei hat eines.</translation>
    </message>
    <message>
        <source>a tag&apos;s name is missing after &apos;&lt;&apos; (a plain &apos;&lt;&apos; is written &amp;lt;).</source>
        <translation>nach „&lt;“ fehlt der Name eines Tags (ein bloßes „&lt;“ schreibt man &amp;lt;).</translation>
    </message>
    <message>
        <source>elements are nested deeper than {}.</source>
        <translation>Elemente sind tiefer als {} Ebenen verschachtelt.</translation>
    </message>
    <message>
        <source>the tag &lt;{}&gt; is never closed.</source>
        <translation>das Tag &lt;{}&gt; wird nie geschlossen.</translation>
    </message>
    <message>
        <source>&lt;{}&gt; has too many attributes.</source>
        <translation>&lt;{}&gt; hat zu viele Attribute.</translation>
    </message>
    <message>
        <source>an attribute&apos;s name is missing in &lt;{}&gt;.</source>
        <translation>in &lt;{}&gt; fehlt der Name eines Attributs.</translation>
    </message>
    <message>
        <source>&apos;=&apos; is missing after &quot;{}&quot;.</source>
        <translation>nach „{}“ fehlt „=“.</translation>
    </message>
    <message>
        <source>the value of &quot;{}&quot; is not in quotation marks.</source>
        <translation>der Wert von „{}“ steht nicht in Anführungszeichen.</translation>
    </message>
    <message>
        <source>the value of &quot;{}&quot; is never closed.</source>
        <translation>der Wert von „{}“ wird nie geschlossen.</translation>
    </message>
    <message>
        <source>a plain &apos;&amp;&apos; is written &amp;amp;.</source>
        <translation>ein bloßes „&amp;“ schreibt man &amp;amp;.</translation>
    </message>
    <message>
        <source>&quot;&amp;{}&quot; is not a known entity (a plain &apos;&amp;&apos; is written &amp;amp;).</source>
        <translation>„&amp;{}“ ist keine bekannte Entität (ein bloßes „&amp;“ schreibt man &amp;amp;).</translation>
    </message>
    <message>
        <source>The virtual tool cannot exist: {}</source>
        <translation>Das virtuelle Werkzeug kann es nicht geben: {}</translation>
    </message>
    <message>
        <source>The virtual arm samples at 200 to 10000 Hz, not at {} Hz.</source>
        <translation>Der virtuelle Arm tastet mit 200 bis 10000 Hz ab, nicht mit {} Hz.</translation>
    </message>
    <message>
        <source>The robot {} has no link {} to mount the sensor on.</source>
        <translation>Der Roboter {} hat kein Glied {}, an dem der Sensor sitzen könnte.</translation>
    </message>
    <message>
        <source>{}: &quot;{}&quot; {}. The file is damaged or was not written by Heft.</source>
        <translation>{}: „{}“ {}. Die Datei ist beschädigt oder wurde nicht von Heft geschrieben.</translation>
    </message>
    <message>
        <source>should be a list</source>
        <translation>sollte eine Liste sein</translation>
    </message>
    <message>
        <source>should hold from_s, to_s and a label free, contact or ignore</source>
        <translation>sollte from_s, to_s und ein label free, contact oder ignore enthalten</translation>
    </message>
    <message>
        <source>should name files</source>
        <translation>sollte Dateien nennen</translation>
    </message>
    <message>
        <source>should name causes</source>
        <translation>sollte Ursachen nennen</translation>
    </message>
    <message>
        <source>should be between 0 and 0.45</source>
        <translation>sollte zwischen 0 und 0,45 liegen</translation>
    </message>
    <message>
        <source>should hold a name and a payload</source>
        <translation>sollte einen Namen und eine Last enthalten</translation>
    </message>
    <message>
        <source>should end in a number</source>
        <translation>sollte mit einer Zahl enden</translation>
    </message>
    <message>
        <source>{} was saved by a newer Heft (session format {}; this one reads up to {}). Update Heft to open it; the file was not changed.</source>
        <translation>{} wurde von einem neueren Heft gespeichert (Sitzungsformat {}; dieses liest bis {}). Aktualisieren Sie Heft, um sie zu öffnen; die Datei wurde nicht verändert.</translation>
    </message>
    <message>
        <source>should end in a number from 1</source>
        <translation>sollte mit einer Zahl ab 1 enden</translation>
    </message>
    <message>
        <source>a slow wave in time</source>
        <translation>einer langsamen Welle in der Zeit</translation>
    </message>
    <message>
        <source>The diagnosis holds no extended model that this version of Heft understands; run heft diagnose again.</source>
        <translation>Die Realitätsprüfung enthält kein erweitertes Modell, das diese Heft-Version versteht; führen Sie sie noch einmal aus.</translation>
    </message>
    <message>
        <source>Was there a knock, a loose plug, or a program that zeroed the sensor while recording?</source>
        <translation>Gab es einen Stoß, einen losen Stecker oder ein Programm, das den Sensor während der Aufnahme genullt hat?</translation>
    </message>
    <message>
        <source>Turn the tool to another pose after the jump and hold: a jump stays, a load turns with gravity.</source>
        <translation>Das Werkzeug nach dem Sprung in eine andere Lage drehen und halten: Ein Sprung bleibt, eine Last dreht sich mit der Schwerkraft.</translation>
    </message>
    <message>
        <source>The difference is flat, steps once, and is flat again, however the tool is held.</source>
        <translation>Die Abweichung ist flach, macht eine Stufe und ist wieder flach, wie man das Werkzeug auch hält.</translation>
    </message>
    <message>
        <source>Let the sensor warm up for half an hour, avoid draughts and re-zero often.</source>
        <translation>Den Sensor eine halbe Stunde warmlaufen lassen, vor Zugluft schützen und oft nullen.</translation>
    </message>
    <message>
        <source>Come back to the same pose three times: a drift reads differently each time.</source>
        <translation>Dreimal in dieselbe Lage zurückkehren: Eine Drift zeigt jedes Mal etwas anderes.</translation>
    </message>
    <message>
        <source>Are force and joint data timestamped by the same clock?</source>
        <translation>Bekommen Kraft und Gelenkwinkel ihre Zeit von einer Uhr, gleich an der Quelle?</translation>
    </message>
    <message>
        <source>Is a filter or averaging switched on in the sensor&apos;s amplifier or driver?</source>
        <translation>Ist im Verstärker oder Treiber des Sensors ein Filter oder eine Mittelung eingeschaltet?</translation>
    </message>
    <message>
        <source>Shake the tool quickly for ten seconds: smoothing makes fast forces smaller, a delay does not.</source>
        <translation>Das Werkzeug zehn Sekunden lang schnell schütteln: Glättung macht schnelle Kräfte kleiner, eine Verspätung nicht.</translation>
    </message>
    <message>
        <source>Late like a delay, but peaks are also cut down, and the noise looks soft.</source>
        <translation>Verspätet wie bei einer Verzögerung, aber Spitzen sind auch niedriger, und das Rauschen wirkt weich.</translation>
    </message>
    <message>
        <source>Slow turning fits well; only starts and stops leave a difference.</source>
        <translation>Langsames Drehen passt gut; nur Anfahren und Anhalten lassen eine Abweichung.</translation>
    </message>
    <message>
        <source>Compare the arrows printed on the sensor with the mount in the setup file.</source>
        <translation>Die Pfeile auf dem Sensor mit der Montage in der Aufbaudatei vergleichen.</translation>
    </message>
    <message>
        <source>The weight shows up on the wrong axis of the sensor, always the same one.</source>
        <translation>Das Gewicht erscheint auf der falschen Achse des Sensors, immer derselben.</translation>
    </message>
    <message>
        <source>Robot base tilted</source>
        <translation>Robotersockel schief</translation>
    </message>
    <message>
        <source>Put a spirit level on the robot&apos;s base, or state the true gravity in the setup file.</source>
        <translation>Eine Wasserwaage auf den Robotersockel legen oder die wahre Schwerkraft in die Aufbaudatei schreiben.</translation>
    </message>
    <message>
        <source>Record once more with a heavier tool: a tilt grows with the weight, a pull does not.</source>
        <translation>Noch einmal mit einem schwereren Werkzeug aufnehmen: Eine Neigung wächst mit dem Gewicht, ein Zug nicht.</translation>
    </message>
    <message>
        <source>A difference that keeps its direction in the room and grows with the tool&apos;s weight.</source>
        <translation>Eine Abweichung, die ihre Richtung im Raum behält und mit dem Gewicht des Werkzeugs wächst.</translation>
    </message>
    <message>
        <source>Hang a known weight from each side of the sensor; check its calibration file.</source>
        <translation>Ein bekanntes Gewicht an jede Seite des Sensors hängen; seine Kalibrierdatei prüfen.</translation>
    </message>
    <message>
        <source>Tilt the tool so that its weight lies on each axis in turn. Equal gains on all axes need a scale.</source>
        <translation>Das Werkzeug so kippen, dass sein Gewicht nacheinander auf jeder Achse liegt. Gleiche Fehler auf allen Achsen verrät nur eine Waage.</translation>
    </message>
    <message>
        <source>The difference on one channel is a small copy of that channel itself.</source>
        <translation>Die Abweichung eines Kanals ist ein kleines Abbild dieses Kanals selbst.</translation>
    </message>
    <message>
        <source>Is the sensor&apos;s own calibration matrix loaded (serial number)?</source>
        <translation>Ist die Kalibriermatrix dieses Sensors geladen (Seriennummer)?</translation>
    </message>
    <message>
        <source>Tilt the tool so that its weight lies on each axis of the sensor in turn.</source>
        <translation>Das Werkzeug so kippen, dass sein Gewicht nacheinander auf jeder Achse des Sensors liegt.</translation>
    </message>
    <message>
        <source>The difference on one channel is a small copy of another channel.</source>
        <translation>Die Abweichung eines Kanals ist ein kleines Abbild eines anderen.</translation>
    </message>
    <message>
        <source>Cable or hose pulls</source>
        <translation>Kabel oder Schlauch zieht</translation>
    </message>
    <message>
        <source>Does the cable or hose hang free of the wrist, with slack in every pose?</source>
        <translation>Hängt das Kabel oder der Schlauch frei vom Handgelenk, mit Spiel in jeder Lage?</translation>
    </message>
    <message>
        <source>Move the tool through a larger space, to where the cable is taut and where it is slack.</source>
        <translation>Das Werkzeug durch einen größeren Raum bewegen, dorthin, wo das Kabel straff ist, und dorthin, wo es durchhängt.</translation>
    </message>
    <message>
        <source>The difference depends on the position of the tool: the same place, the same pull, at any speed.</source>
        <translation>Die Abweichung hängt vom Ort des Werkzeugs ab: dieselbe Stelle, derselbe Zug, bei jeder Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Is there a balancer, a hose or a weight that pulls in one direction?</source>
        <translation>Gibt es einen Federzug, einen Schlauch oder ein Gewicht, das in eine Richtung zieht?</translation>
    </message>
    <message>
        <source>A difference that keeps its direction in the room, whatever the tool weighs.</source>
        <translation>Eine Abweichung, die ihre Richtung im Raum behält, egal, wie schwer das Werkzeug ist.</translation>
    </message>
    <message>
        <source>Repeat one movement slowly, faster and fast.</source>
        <translation>Eine Bewegung langsam, schneller und schnell wiederholen.</translation>
    </message>
    <message>
        <source>The difference follows the speed: none at rest, twice as much at twice the speed.</source>
        <translation>Die Abweichung folgt dem Tempo: keine in Ruhe, doppelt so viel bei doppeltem Tempo.</translation>
    </message>
    <message>
        <source>Does a cable rub in a clamp, a cover scrape, a sheath stiffen?</source>
        <translation>Reibt ein Kabel in einer Klemme, schleift eine Hülle, ist ein Mantel steif?</translation>
    </message>
    <message>
        <source>Shake the tool by hand and listen: a loose part, a liquid, a hanging hose?</source>
        <translation>Das Werkzeug von Hand schütteln und lauschen: ein loses Teil, eine Flüssigkeit, ein hängender Schlauch?</translation>
    </message>
    <message>
        <source>Tighten the screws between arm, sensor and tool; look for rubber or thin adapters.</source>
        <translation>Die Schrauben zwischen Arm, Sensor und Werkzeug anziehen; nach Gummi oder dünnen Zwischenplatten sehen.</translation>
    </message>
    <message>
        <source>Tap the tool with a finger while the arm holds still.</source>
        <translation>Mit dem Finger an das Werkzeug tippen, während der Arm stillhält.</translation>
    </message>
    <message>
        <source>Was a part picked up or put down? Mark only the segment that you mean.</source>
        <translation>Wurde ein Teil aufgenommen oder abgelegt? Nur den gemeinten Abschnitt markieren.</translation>
    </message>
    <message>
        <source>Turn the tool to another pose after the change: a load turns with gravity, a jump does not.</source>
        <translation>Das Werkzeug nach der Änderung in eine andere Lage drehen: Eine Last dreht sich mit der Schwerkraft, ein Sprung nicht.</translation>
    </message>
    <message>
        <source>Was the tool set down, bumped or held?</source>
        <translation>Wurde das Werkzeug abgesetzt, angestoßen oder vorn angefasst?</translation>
    </message>
    <message>
        <source>Repeat the motion without touching anything.</source>
        <translation>Die Bewegung wiederholen, ohne etwas zu berühren.</translation>
    </message>
    <message>
        <source>Short, large differences at a few moments; between them everything fits.</source>
        <translation>Kurze, große Abweichungen in wenigen Augenblicken; dazwischen passt alles.</translation>
    </message>
    <message>
        <source>Use a range that fits the load, and check the sensor&apos;s zero.</source>
        <translation>Einen Messbereich benutzen, der zur Last passt, und die Null des Sensors prüfen.</translation>
    </message>
    <message>
        <source>Repeat the motion more slowly, or with a lighter tool.</source>
        <translation>Die Bewegung langsamer oder mit einem leichteren Werkzeug wiederholen.</translation>
    </message>
    <message>
        <source>The measured curve is cut off flat at the top.</source>
        <translation>Die gemessene Kurve ist oben flach abgeschnitten.</translation>
    </message>
    <message>
        <source>Check that joint&apos;s calibration and the robot description of this recording.</source>
        <translation>Die Kalibrierung dieses Gelenks und die Roboterbeschreibung dieser Aufnahme prüfen.</translation>
    </message>
    <message>
        <source>A difference that depends on the pose: a tilt that is not the same everywhere.</source>
        <translation>Eine Abweichung, die von der Lage abhängt: eine Neigung, die nicht überall gleich ist.</translation>
    </message>
    <message>
        <source>Check the sensor&apos;s cable and plug, and what switches on nearby.</source>
        <translation>Kabel und Stecker des Sensors prüfen, und was in der Nähe schaltet.</translation>
    </message>
    <message>
        <source>Hold still for a few seconds: spikes come without motion.</source>
        <translation>Einige Sekunden stillhalten: Ausreißer kommen ohne Bewegung.</translation>
    </message>
    <message>
        <source>Single readings far off, with normal ones on both sides.</source>
        <translation>Einzelne Werte weit daneben, mit gewöhnlichen zu beiden Seiten.</translation>
    </message>
    <message>
        <source>Slow motion fits; fast turning leaves a difference that grows with the square of its speed.</source>
        <translation>Langsame Bewegung passt; schnelles Drehen lässt eine Abweichung, die mit dem Quadrat des Tempos wächst.</translation>
    </message>
    <message>
        <source>Record joint angles at the full rate; check the size of gravity in the setup file.</source>
        <translation>Gelenkwinkel mit voller Rate aufnehmen; den Betrag der Schwerkraft in der Aufbaudatei prüfen.</translation>
    </message>
    <message>
        <source>Record once more with stronger smoothing and compare.</source>
        <translation>Noch einmal mit stärkerer Glättung aufnehmen und vergleichen.</translation>
    </message>
    <message>
        <source>The fast parts of the motion are too large or too small in the simulation, the slow ones fit.</source>
        <translation>Die schnellen Teile der Bewegung sind in der Simulation zu groß oder zu klein, die langsamen passen.</translation>
    </message>
    <message>
        <source>Was the sensor overloaded, glued or pinched? Check its screws.</source>
        <translation>Wurde der Sensor überlastet, verklebt oder eingeklemmt? Seine Schrauben prüfen.</translation>
    </message>
    <message>
        <source>Load the sensor slowly up and down in one direction, in small and large steps.</source>
        <translation>Den Sensor in einer Richtung langsam be- und entlasten, in kleinen und großen Stufen.</translation>
    </message>
    <message>
        <source>The difference lags behind the load itself: one value on the way up, another on the way down.</source>
        <translation>Die Abweichung hinkt der Last nach: ein Wert auf dem Hinweg, ein anderer auf dem Rückweg.</translation>
    </message>
    <message>
        <source>Frames or signs mixed up</source>
        <translation>Achsen oder Vorzeichen vertauscht</translation>
    </message>
    <message>
        <source>Compare the sensor&apos;s manual with the setup file: axes, signs, gravity.</source>
        <translation>Das Handbuch des Sensors mit der Aufbaudatei vergleichen: Achsen, Vorzeichen, Schwerkraft.</translation>
    </message>
    <message>
        <source>Not needed: the error is obvious.</source>
        <translation>Keine ist nötig: Der Fehler ist zu groß, um übersehen zu werden.</translation>
    </message>
    <message>
        <source>Check the connection, and record at the sensor&apos;s own rate.</source>
        <translation>Die Verbindung prüfen und mit der Rate des Sensors aufnehmen.</translation>
    </message>
    <message>
        <source>The measured curve has flat steps or holes where it should run on.</source>
        <translation>Die gemessene Kurve hat Stufen oder Löcher, wo sie weiterlaufen sollte.</translation>
    </message>
    <message>
        <source>Let the sensor or the robot stamp the readings, not a busy computer.</source>
        <translation>Lassen Sie Sensor oder Roboter die Werte stempeln, nicht einen beschäftigten Rechner.</translation>
    </message>
    <message>
        <source>Choose a finer measuring range, or a file format with more digits.</source>
        <translation>Wählen Sie einen feineren Messbereich, oder ein Dateiformat mit mehr Stellen.</translation>
    </message>
    <message>
        <source>The sensor&apos;s zero drifts: {} by {} {} per second.</source>
        <translation>Die Null des Sensors wandert: {} um {} {} pro Sekunde.</translation>
    </message>
    <message>
        <source>{} % of the readings are zero throughout: lost packets.</source>
        <translation>{} % der Messwerte sind durchweg null: verlorene Pakete.</translation>
    </message>
    <message>
        <source>{} % of the readings are missing.</source>
        <translation>{} % der Messwerte fehlen.</translation>
    </message>
    <message>
        <source>A cable twists back as the tool turns: {} N m per radian.</source>
        <translation>Ein Kabel dreht zurück, wenn sich das Werkzeug dreht: {} N m pro Radiant.</translation>
    </message>
    <message>
        <source>A cable or hose pulls the tool back, by up to {} N per metre.</source>
        <translation>Ein Kabel oder Schlauch zieht das Werkzeug zurück, mit bis zu {} N pro Meter.</translation>
    </message>
    <message>
        <source>The channel {} reads {} % too much.</source>
        <translation>Der Kanal {} zeigt {} % zu viel.</translation>
    </message>
    <message>
        <source>The channel {} reads {} % too little.</source>
        <translation>Der Kanal {} zeigt {} % zu wenig.</translation>
    </message>
    <message>
        <source>{} of {} shows up in {}.</source>
        <translation>{} von {} erscheint in {}.</translation>
    </message>
    <message>
        <source>At {} s the sensor&apos;s zero jumped by {} N.</source>
        <translation>Bei {} s sprang die Null des Sensors um {} N.</translation>
    </message>
    <message>
        <source>The force readings arrive {} ms late.</source>
        <translation>Die Kraftwerte kommen {} ms zu spät.</translation>
    </message>
    <message>
        <source>The force readings are smoothed over {} ms.</source>
        <translation>Die Kraftwerte sind über {} ms geglättet.</translation>
    </message>
    <message>
        <source>The reported velocities come {} ms late; Heft can use the positions instead.</source>
        <translation>Die gemeldeten Geschwindigkeiten kommen {} ms zu spät; Heft kann stattdessen die Lagen benutzen.</translation>
    </message>
    <message>
        <source>The robot&apos;s base is tilted by {} degrees against the stated gravity.</source>
        <translation>Der Robotersockel ist um {} Grad gegen die angegebene Schwerkraft geneigt.</translation>
    </message>
    <message>
        <source>At {} s the load became {} g heavier.</source>
        <translation>Bei {} s wurde die Last {} g schwerer.</translation>
    </message>
    <message>
        <source>At {} s the load became {} g lighter.</source>
        <translation>Bei {} s wurde die Last {} g leichter.</translation>
    </message>
    <message>
        <source>The tool touched something from {} to {} s, with up to {} N.</source>
        <translation>Das Werkzeug berührte von {} bis {} s etwas, mit bis zu {} N.</translation>
    </message>
    <message>
        <source>The tool touched something {} times, with up to {} N.</source>
        <translation>Das Werkzeug berührte {}-mal etwas, mit bis zu {} N.</translation>
    </message>
    <message>
        <source>The sensor reached the end of its range in {} % of the readings.</source>
        <translation>Der Sensor war in {} % der Messwerte am Ende seines Bereichs.</translation>
    </message>
    <message>
        <source>The reported velocities are {} % off; Heft can use the positions instead.</source>
        <translation>Die gemeldeten Geschwindigkeiten liegen {} % daneben; Heft kann stattdessen die Lagen benutzen.</translation>
    </message>
    <message>
        <source>The time stamps come up to {} ms early or late; Heft takes the rows as evenly spaced.</source>
        <translation>Die Zeitstempel kommen bis zu {} ms zu früh oder zu spät; Heft nimmt die Zeilen als gleichmäßig verteilt.</translation>
    </message>
    <message>
        <source>The force readings come in steps of {}.</source>
        <translation>Die Kraftwerte kommen in Stufen von {}.</translation>
    </message>
    <message>
        <source>The torque readings come in steps of {}.</source>
        <translation>Die Momentwerte kommen in Stufen von {}.</translation>
    </message>
    <message>
        <source>Correct sensor.mount.rpy_rad in the setup file.</source>
        <translation>Berichtigen Sie sensor.mount.rpy_rad in der Aufbaudatei.</translation>
    </message>
    <message>
        <source>force {}</source>
        <translation>Kraft {}</translation>
    </message>
    <message>
        <source>torque {}</source>
        <translation>Moment {}</translation>
    </message>
    <message>
        <source>a rhythm of {:.2g} Hz</source>
        <translation>einem Rhythmus von {:.2g} Hz</translation>
    </message>
    <message>
        <source>where the tool is</source>
        <translation>dem Ort des Werkzeugs</translation>
    </message>
    <message>
        <source>how fast the tool moves</source>
        <translation>dem Tempo des Werkzeugs</translation>
    </message>
    <message>
        <source>the direction in which the tool moves</source>
        <translation>der Bewegungsrichtung des Werkzeugs</translation>
    </message>
    <message>
        <source>the joint angles</source>
        <translation>den Gelenkwinkeln</translation>
    </message>
    <message>
        <source>the joint angles, several times a turn</source>
        <translation>den Gelenkwinkeln, mehrmals je Umdrehung</translation>
    </message>
    <message>
        <source>the direction in which joints turn</source>
        <translation>der Drehrichtung der Gelenke</translation>
    </message>
    <message>
        <source>the load on the sensor</source>
        <translation>der Last am Sensor</translation>
    </message>
    <message>
        <source>how fast the load changes</source>
        <translation>dem Wechsel der Last</translation>
    </message>
    <message>
        <source>how fast the tool turns</source>
        <translation>dem Drehtempo des Werkzeugs</translation>
    </message>
    <message>
        <source>the direction in which the tool turns</source>
        <translation>der Drehrichtung des Werkzeugs</translation>
    </message>
    <message>
        <source>Give it as the recording itself, or write a CSV of it with heft convert IN OUT.csv.</source>
        <translation>Öffnen Sie sie selbst als Aufnahme, oder machen Sie daraus ein CSV mit heft convert IN OUT.csv.</translation>
    </message>
    <message>
        <source>a ROS 1 bag</source>
        <translation>ein ROS-1-Bag</translation>
    </message>
    <message>
        <source>an MCAP recording</source>
        <translation>eine MCAP-Aufnahme</translation>
    </message>
    <message>
        <source>an SQLite database, perhaps a ROS 2 bag</source>
        <translation>eine SQLite-Datenbank, vielleicht ein ROS-2-Bag</translation>
    </message>
    <message>
        <source>a gzip archive</source>
        <translation>ein gzip-Archiv</translation>
    </message>
    <message>
        <source>Unpack it first with gunzip.</source>
        <translation>Entpacken Sie es zuerst mit gunzip.</translation>
    </message>
    <message>
        <source>a zstd archive</source>
        <translation>ein zstd-Archiv</translation>
    </message>
    <message>
        <source>Unpack it first with unzstd.</source>
        <translation>Entpacken Sie es zuerst mit unzstd.</translation>
    </message>
    <message>
        <source>a ZIP archive or an office document</source>
        <translation>ein ZIP-Archiv oder ein Office-Dokument</translation>
    </message>
    <message>
        <source>Save the sheet as CSV first.</source>
        <translation>Speichern Sie die Tabelle zuerst als CSV.</translation>
    </message>
    <message>
        <source>UTF-16 text</source>
        <translation>UTF-16-Text</translation>
    </message>
    <message>
        <source>Save it as UTF-8 first.</source>
        <translation>Speichern Sie ihn zuerst als UTF-8.</translation>
    </message>
    <message>
        <source>Give the CSV of the recording; its setup file is found beside it.</source>
        <translation>Öffnen Sie das CSV der Aufnahme; die Aufbaudatei daneben wird gefunden.</translation>
    </message>
    <message>
        <source>{} needs 1 dimension in metres ({}), but {} are given.</source>
        <translation>{} braucht 1 Maß in Metern ({}), angegeben sind aber {}.</translation>
    </message>
    <message>
        <source>{} needs {} dimensions in metres ({}), but 1 is given.</source>
        <translation>{} braucht {} Maße in Metern ({}), angegeben ist aber 1.</translation>
    </message>
    <message>
        <source>{} needs {} dimensions in metres ({}), but {} are given.</source>
        <translation>{} braucht {} Maße in Metern ({}), angegeben sind aber {}.</translation>
    </message>
    <message>
        <source>--use wrench={} takes it nevertheless.</source>
        <translation>--use wrench={} nimmt es trotzdem.</translation>
    </message>
    <message>
        <source>Name it time (in seconds), or choose it with --use time=NAME.</source>
        <translation>Nennen Sie sie time (in Sekunden), oder sagen Sie mit --use time=NAME, welche es ist.</translation>
    </message>
    <message>
        <source>Set sensor.mount.parent in the setup file to one of: {}.</source>
        <translation>Setzen Sie sensor.mount.parent in der Aufbaudatei auf eines von: {}.</translation>
    </message>
    <message>
        <source>The sensor&apos;s mount names the link &quot;{}&quot;, which the robot &quot;{}&quot; does not have.</source>
        <translation>Die Halterung des Sensors nennt das Glied „{}“, das der Roboter „{}“ nicht hat.</translation>
    </message>
    <message>
        <source>Delay t</source>
        <translation>Verspätung t</translation>
    </message>
    <message>
        <source>Delay of the motion t</source>
        <translation>Verspätung der Bewegung t</translation>
    </message>
    <message>
        <source>Time constant T</source>
        <translation>Zeitkonstante T</translation>
    </message>
    <message>
        <source>Stiffness k</source>
        <translation>Steifigkeit k</translation>
    </message>
    <message>
        <source>Drag d</source>
        <translation>Widerstand d</translation>
    </message>
    <message>
        <source>Friction F</source>
        <translation>Reibung F</translation>
    </message>
    <message>
        <source>Mass m</source>
        <translation>Masse m</translation>
    </message>
    <message>
        <source>Frequency f</source>
        <translation>Frequenz f</translation>
    </message>
    <message>
        <source>Damping ratio ζ</source>
        <translation>Dämpfungsgrad ζ</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Missing share</source>
        <translation>Fehlender Anteil</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Share of the readings</source>
        <translation>Anteil der Messwerte</translation>
    </message>
    <message>
        <source>Spread of the time stamps</source>
        <translation>Streuung der Zeitstempel</translation>
    </message>
    <message>
        <source>Readings that repeat</source>
        <translation>Messwerte, die sich wiederholen</translation>
    </message>
    <message>
        <source>Readings that are zero</source>
        <translation>Messwerte, die null sind</translation>
    </message>
    <message>
        <source>Readings that are missing</source>
        <translation>Messwerte, die fehlen</translation>
    </message>
    <message>
        <source>Greatest force F</source>
        <translation>Größte Kraft F</translation>
    </message>
    <message>
        <source>Step of the force readings</source>
        <translation>Stufe der Kraftwerte</translation>
    </message>
    <message>
        <source>Stiffness along {0}, k{0}</source>
        <translation>Steifigkeit entlang {0}, k{0}</translation>
    </message>
    <message>
        <source>Force along {0}, F{0}</source>
        <translation>Kraft entlang {0}, F{0}</translation>
    </message>
    <message>
        <source>Torque about {0}, M{0}</source>
        <translation>Drehmoment um {0}, M{0}</translation>
    </message>
    <message>
        <source>Drag along {0}, d{0}</source>
        <translation>Widerstand entlang {0}, d{0}</translation>
    </message>
    <message>
        <source>Mass times offset along {0}, m{0}</source>
        <translation>Masse mal Abstand entlang {0}, m{0}</translation>
    </message>
    <message>
        <source>Share along {0}</source>
        <translation>Anteil entlang {0}</translation>
    </message>
    <message>
        <source>Size in {}</source>
        <translation>Größe in {}</translation>
    </message>
    <message>
        <source>Step of the torque readings</source>
        <translation>Stufe der Momentwerte</translation>
    </message>
    <message>
        <source>End of the range, {}</source>
        <translation>Ende des Bereichs, {}</translation>
    </message>
    <message>
        <source>{} seen in {}</source>
        <translation>{}, gesehen in {}</translation>
    </message>
    <message>
        <source>Wave {} of {}</source>
        <translation>Welle {} von {}</translation>
    </message>
    <message>
        <source>{} ({})</source>
        <translation>{} ({})</translation>
    </message>
    <message>
        <source>At {} s the load moved on the tool; its weight hardly changed ({} g).</source>
        <translation>Bei {} s verrutschte die Last am Werkzeug; ihr Gewicht änderte sich kaum ({} g).</translation>
    </message>
    <message>
        <source>Columns and topics are taken as {} says.</source>
        <translation>Spalten und Topics werden so genommen, wie {} es sagt.</translation>
    </message>
    <message>
        <source>Record the sensor&apos;s wrench and the joints or the pose.</source>
        <translation>Nehmen Sie Kraft und Moment des Sensors und die Gelenke oder die Pose auf.</translation>
    </message>
    <message>
        <source>The transport&apos;s delay is not known.</source>
        <translation>Die Verspätung durch die Übertragung ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Were they recorded together, or is one clock late?</source>
        <translation>Wurden sie zusammen aufgenommen, oder geht eine Uhr nach?</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>Gelenkwinkel</translation>
    </message>
    <message>
        <source>velocities</source>
        <translation>Gelenkgeschwindigkeiten</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>quaternion</source>
        <translation>Quaternion</translation>
    </message>
    <message>
        <source>{} has one, but it is {}.</source>
        <translation>{} hat sie, aber es ist {}.</translation>
    </message>
    <message>
        <source>chosen by the user</source>
        <translation>so gewählt</translation>
    </message>
    <message>
        <source>the scale of {} is {}.</source>
        <translation>der Faktor von {} ist {}.</translation>
    </message>
    <message>
        <source>&quot;pose_of&quot; is neither sensor nor flange.</source>
        <translation>„pose_of“ ist weder sensor noch flange.</translation>
    </message>
    <message>
        <source>&quot;clock&quot; is neither header nor received.</source>
        <translation>„clock“ ist weder header noch received.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is not known.</source>
        <translation>„{}“ ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The recording has joint angles, but no robot is named.</source>
        <translation>Die Aufnahme hat Gelenkwinkel, aber es ist kein Roboter genannt.</translation>
    </message>
    <message>
        <source>The recording has {} joints, the robot &quot;{}&quot; has {}.</source>
        <translation>Die Aufnahme hat {} Gelenke, der Roboter „{}“ hat {}.</translation>
    </message>
    <message>
        <source>Write the time of each sample in seconds.</source>
        <translation>Schreiben Sie die Zeit jedes Messwerts in Sekunden.</translation>
    </message>
    <message>
        <source>Write time in seconds, not nanoseconds or microseconds.</source>
        <translation>Schreiben Sie die Zeit in Sekunden, nicht in Nano- oder Mikrosekunden.</translation>
    </message>
    <message>
        <source>Write time in seconds, not milliseconds.</source>
        <translation>Schreiben Sie die Zeit in Sekunden, nicht in Millisekunden.</translation>
    </message>
    <message>
        <source>Force x</source>
        <translation>Kraft x</translation>
    </message>
    <message>
        <source>Force y</source>
        <translation>Kraft y</translation>
    </message>
    <message>
        <source>Force z</source>
        <translation>Kraft z</translation>
    </message>
    <message>
        <source>Torque x</source>
        <translation>Moment x</translation>
    </message>
    <message>
        <source>Torque y</source>
        <translation>Moment y</translation>
    </message>
    <message>
        <source>Torque z</source>
        <translation>Moment z</translation>
    </message>
    <message>
        <source>{} is cut off at {:.4g} {}: the sensor is at the end of its range.</source>
        <translation>{} ist bei {:.4g} {} abgeschnitten: Der Sensor ist am Ende seines Bereichs.</translation>
    </message>
    <message>
        <source>Another version of Heft saved {} in a form that this one does not know: not part of these numbers.</source>
        <translation>Eine andere Version von Heft hat {} in einer Form gespeichert, die diese nicht kennt: nicht in diesen Zahlen enthalten.</translation>
    </message>
    <message>
        <source>Run the reality check again.</source>
        <translation>Führen Sie die Realitätsprüfung noch einmal aus.</translation>
    </message>
    <message>
        <source>The reported velocities are noisy, by {} % of the motion&apos;s speed; Heft can use the positions instead.</source>
        <translation>Die gemeldeten Geschwindigkeiten rauschen um {} % der Geschwindigkeit der Bewegung; Heft kann stattdessen die Lagen nehmen.</translation>
    </message>
    <message>
        <source>From {} to {} s the load became {} g heavier.</source>
        <translation>Von {} bis {} s wurde die Last {} g schwerer.</translation>
    </message>
    <message>
        <source>From {} to {} s the load became {} g lighter.</source>
        <translation>Von {} bis {} s wurde die Last {} g leichter.</translation>
    </message>
    <message>
        <source>Speed below which it sticks v</source>
        <translation>Geschwindigkeit, unter der es haftet, v</translation>
    </message>
    <message>
        <source>The readings hum at {:.0f} Hz, by {:.2g} N and {:.2g} N m.</source>
        <translation>Die Messwerte brummen mit {:.0f} Hz, um {:.2g} N und {:.2g} N m.</translation>
    </message>
    <message>
        <source>That is the mains: check the sensor&apos;s shield and earth.</source>
        <translation>Das ist das Stromnetz: Prüfen Sie Schirm und Erdung des Sensors.</translation>
    </message>
    <message>
        <source>a rhythm of {:.0f} Hz</source>
        <translation>einem Rhythmus von {:.0f} Hz</translation>
    </message>
    <message>
        <source>noise that comes and goes</source>
        <translation>Rauschen, das kommt und geht</translation>
    </message>
    <message>
        <source>Smoothed over T</source>
        <translation>Geglättet über T</translation>
    </message>
    <message>
        <source>Length when slack L</source>
        <translation>Länge, solange schlaff, L</translation>
    </message>
    <message>
        <source>At {} s the sensor&apos;s zero jumped by {} N m.</source>
        <translation>Bei {} s sprang die Null des Sensors um {} N m.</translation>
    </message>
    <message>
        <source>a shaking of {:.0f} to {:.0f} Hz</source>
        <translation>einem Rütteln von {:.0f} bis {:.0f} Hz</translation>
    </message>
    <message>
        <source>{} readings are spikes; Heft replaced them by their neighbours.</source>
        <translation>{} Messwerte sind Ausreißer; Heft hat sie durch das ersetzt, was daneben liegt.</translation>
    </message>
    <message>
        <source>The recorded motion is noisy: accelerations from it are {} N off, so Heft smooths it more, from {} Hz on.</source>
        <translation>Die aufgezeichnete Bewegung rauscht: Beschleunigungen daraus liegen um {} N daneben, deshalb glättet Heft sie stärker, ab {} Hz.</translation>
    </message>
    <message>
        <source>{} samples ({:.2g} %) had spikes in the wrench and were replaced by their neighbours.</source>
        <translation>{} Messwerte ({:.2g} %) enthielten Ausreißer bei Kraft oder Moment und wurden durch das ersetzt, was daneben liegt.</translation>
    </message>
    <message>
        <source>Friction along {0}</source>
        <translation>Reibung längs {0}</translation>
    </message>
    <message>
        <source>short knocks</source>
        <translation>kurzen Stößen</translation>
    </message>
    <message>
        <source>Time constant of warming up T</source>
        <translation>Zeitkonstante des Aufwärmens T</translation>
    </message>
    <message>
        <source>Something knocks {} times, first at {:.1f} s.</source>
        <translation>Etwas klopft {}-mal, zuerst bei {:.1f} s.</translation>
    </message>
    <message>
        <source>Shake the tool by hand and listen: is a part of it loose?</source>
        <translation>Schütteln Sie das Werkzeug von Hand und hören Sie hin: Ist ein Teil lose?</translation>
    </message>
    <message>
        <source>The gain of {} changes by {:+.1f} % during the recording, as when a sensor warms up.</source>
        <translation>Die Verstärkung von {} ändert sich während der Aufnahme um {:+.1f} %, wie wenn ein Sensor warm wird.</translation>
    </message>
    <message>
        <source>how hard the joints speed up and slow down</source>
        <translation>dem Beschleunigen und Bremsen der Gelenke</translation>
    </message>
    <message>
        <source>Rate in {}</source>
        <translation>Änderung je Sekunde: {}</translation>
    </message>
    <message>
        <source>Bend in {}</source>
        <translation>Krümmung: {}</translation>
    </message>
    <message>
        <source>Something on the tool changes at once {} times, first at {:.1f} s.</source>
        <translation>Etwas am Werkzeug ändert sich {} Mal schlagartig, zuerst bei {:.1f} s.</translation>
    </message>
    <message>
        <source>Look at what switches there: a gripper, a valve, a part that slides.</source>
        <translation>Schauen Sie nach, was dort schaltet: ein Greifer, ein Ventil, ein Teil, das rutscht.</translation>
    </message>
    <message>
        <source>sudden changes</source>
        <translation>plötzlichen Änderungen</translation>
    </message>
    <message>
        <source>what the load was before</source>
        <translation>der Last von vorher</translation>
    </message>
    <message>
        <source>what the load was while the tool stood still</source>
        <translation>der Last, während das Werkzeug stillstand</translation>
    </message>
    <message>
        <source>readings that stick at one value</source>
        <translation>Messwerten, die an einem Wert hängen bleiben</translation>
    </message>
    <message>
        <source>Wave {} of the course</source>
        <translation>Welle {} des Verlaufs</translation>
    </message>
    <message>
        <source>The gain of all channels changes by {:+.1f} % during the recording, as when a sensor warms up.</source>
        <translation>Die Verstärkung aller Kanäle ändert sich während der Aufnahme um {:+.1f} %, wie wenn ein Sensor warm wird.</translation>
    </message>
    <message>
        <source>one channel of the sensor alone</source>
        <translation>einem einzelnen Kanal des Sensors</translation>
    </message>
    <message>
        <source>Drag along the tool&apos;s {0}, d{0}</source>
        <translation>Widerstand entlang {0} des Werkzeugs, d{0}</translation>
    </message>
    <message>
        <source>The robot&apos;s base tilts by {} degrees during the recording.</source>
        <translation>Der Sockel des Roboters neigt sich während der Aufnahme um {} Grad.</translation>
    </message>
    <message>
        <source>something that swings to and fro</source>
        <translation>hin und her schwingenden Kräften</translation>
    </message>
    <message>
        <source>the centre of mass, as if the robot&apos;s base moved</source>
        <translation>dem Schwerpunkt (als bewegte sich der Sockel des Roboters)</translation>
    </message>
    <message>
        <source>what the channels read before</source>
        <translation>früheren Anzeigen der Kanäle</translation>
    </message>
    <message>
        <source>what a channel itself reads, in waves</source>
        <translation>Wellen über der Anzeige eines Kanals selbst</translation>
    </message>
    <message>
        <source>some channels of the sensor alone, slowly</source>
        <translation>langsamen Änderungen einzelner Kanäle</translation>
    </message>
    <message>
        <source>The readings shake for a moment {} times, first at {:.1f} s.</source>
        <translation>Die Messwerte zittern {}-mal für einen Augenblick, zuerst bei {:.1f} s.</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>gravity’s direction, {}</source>
        <translation>Richtung der Schwerkraft, {}</translation>
    </message>
    <message>
        <source>how gravity’s direction changes, {}</source>
        <translation>Wechsel der Schwerkraftrichtung, {}</translation>
    </message>
    <message>
        <source>position, {}</source>
        <translation>Ort, {}</translation>
    </message>
    <message>
        <source>velocity, {}</source>
        <translation>Geschwindigkeit, {}</translation>
    </message>
    <message>
        <source>sign of the velocity, {}</source>
        <translation>Vorzeichen der Geschwindigkeit, {}</translation>
    </message>
    <message>
        <source>acceleration, {}</source>
        <translation>Beschleunigung, {}</translation>
    </message>
    <message>
        <source>turning, {}</source>
        <translation>Drehung, {}</translation>
    </message>
    <message>
        <source>load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>channels that are mixed up for a while</source>
        <translation>Kanälen, die eine Weile vertauscht sind</translation>
    </message>
    <message>
        <source>the size of all readings together</source>
        <translation>der Größe aller Anzeigen zugleich</translation>
    </message>
    <message>
        <source>time alone, as regular as a clock</source>
        <translation>der Zeit allein, so regelmäßig wie eine Uhr</translation>
    </message>
    <message>
        <source>From {} to {} s the tool carried {} g more.</source>
        <translation>Von {} bis {} s trug das Werkzeug {} g mehr.</translation>
    </message>
    <message>
        <source>The tool carried {} g more {} times, first from {} to {} s.</source>
        <translation>{} g mehr trug das Werkzeug {}-mal, zuerst von {} bis {} s.</translation>
    </message>
    <message>
        <source>Correct how the sensor is mounted where the recorded poses are worked out: the recording states them itself, and the setup file&apos;s mount is not used.</source>
        <translation>Berichtigen Sie den Einbau des Sensors dort, wo die aufgezeichneten Lagen berechnet werden: Die Aufnahme nennt sie selbst, der Einbau in der Aufbaudatei wird nicht benutzt.</translation>
    </message>
    <message>
        <source>Time from corner to corner</source>
        <translation>Zeit von Ecke zu Ecke</translation>
    </message>
    <message>
        <source>Step of the angles</source>
        <translation>Stufe der Winkel</translation>
    </message>
    <message>
        <source>Step of the positions</source>
        <translation>Stufe der Positionen</translation>
    </message>
    <message>
        <source>readings of another moment</source>
        <translation>Messwerten eines anderen Augenblicks</translation>
    </message>
    <message>
        <source>a few moments alone</source>
        <translation>einigen Augenblicken allein</translation>
    </message>
    <message>
        <source>steps that a channel never reads</source>
        <translation>Stufen, die ein Kanal nie anzeigt</translation>
    </message>
    <message>
        <source>The motion is recorded every {} ms only, with straight lines between: accelerations from it are wrong at every corner.</source>
        <translation>Die Bewegung wurde nur alle {} ms aufgezeichnet, dazwischen gerade Linien: Beschleunigungen daraus sind an jeder Ecke falsch.</translation>
    </message>
    <message>
        <source>The joint angles come in steps of {} degrees: accelerations from them are rough.</source>
        <translation>Die Gelenkwinkel kommen in Stufen von {} Grad: Beschleunigungen daraus sind grob.</translation>
    </message>
    <message>
        <source>The positions come in steps of {} mm: accelerations from them are rough.</source>
        <translation>Die Positionen kommen in Stufen von {} mm: Beschleunigungen daraus sind grob.</translation>
    </message>
    <message>
        <source>torques without a force</source>
        <translation>Drehmomenten ohne eine Kraft</translation>
    </message>
    <message>
        <source>Check the sensor&apos;s cable and plug; mark the moment as &quot;ignore&quot;.</source>
        <translation>Prüfen Sie Kabel und Stecker des Sensors; markieren Sie den Moment als „ignoriert“.</translation>
    </message>
    <message>
        <source>blows from outside</source>
        <translation>Stößen von außen</translation>
    </message>
    <message>
        <source>{} is frozen from {:.1f} to {:.1f} s, while the others go on.</source>
        <translation>{} steht von {:.1f} bis {:.1f} s still, während die anderen weitergehen.</translation>
    </message>
    <message>
        <source>Check that channel&apos;s cable and plug; mark the segment as &quot;ignore&quot;.</source>
        <translation>Prüfen Sie Kabel und Stecker dieses Kanals; markieren Sie den Abschnitt als „ignoriert“.</translation>
    </message>
    <message>
        <source>Positions smoothed over T</source>
        <translation>Positionen über T geglättet</translation>
    </message>
    <message>
        <source>Positions that repeat</source>
        <translation>Positionen, die sich wiederholen</translation>
    </message>
    <message>
        <source>The readings shake in some parts of the recording, and not in others that move alike.</source>
        <translation>Die Messwerte zittern in manchen Teilen der Aufnahme und in anderen, die sich gleich bewegen, nicht.</translation>
    </message>
    <message>
        <source>what a channel itself reads</source>
        <translation>dem, was ein Kanal selbst misst</translation>
    </message>
    <message>
        <source>Nothing was found that could be checked on {}.</source>
        <translation>Es wurde nichts gefunden, das sich an {} prüfen ließe.</translation>
    </message>
    <message>
        <source>What was found belongs to its own recording; nothing of it can be checked on {}.</source>
        <translation>Was gefunden wurde, gehört zu seiner eigenen Aufnahme; nichts davon lässt sich an {} prüfen.</translation>
    </message>
    <message>
        <source>Holds on {}, too: {}.</source>
        <translation>Trifft auch auf {} zu: {}.</translation>
    </message>
    <message>
        <source>Not checked, since it belongs to one recording: {}.</source>
        <translation>Nicht geprüft, weil es zu einer einzelnen Aufnahme gehört: {}.</translation>
    </message>
    <message>
        <source>where in the tool its weight sits</source>
        <translation>der Stelle, an der das Gewicht im Werkzeug sitzt</translation>
    </message>
    <message>
        <source>Look for what knocks or jerks, and check the sensor&apos;s plug, if there are more next time.</source>
        <translation>Werden es beim nächsten Mal mehr: nachsehen, was klopft oder ruckt, und den Stecker des Sensors prüfen.</translation>
    </message>
    <message>
        <source>Check that it was logged, or choose a finer measuring range of the sensor.</source>
        <translation>Prüfen, ob der Kanal aufgezeichnet wurde, oder einen feineren Messbereich des Sensors wählen.</translation>
    </message>
    <message>
        <source>Record angles with more digits and at a higher rate, if the robot has them.</source>
        <translation>Winkel mit mehr Stellen und höherer Rate aufzeichnen, falls der Roboter sie liefert.</translation>
    </message>
    <message>
        <source>If so, write {} into the setup file.</source>
        <translation>Wenn ja, schreiben Sie {} in die Aufbaudatei.</translation>
    </message>
    <message>
        <source>the map file scales {} by {}, and {} is stated, too.</source>
        <translation>die Zuordnungsdatei skaliert {} mit {}, und {} ist ebenfalls angegeben.</translation>
    </message>
    <message>
        <source>The wrench is stated in the base&apos;s axes or about its origin, and the samples do not tell where the sensor is.</source>
        <translation>Kraft und Moment sind in den Achsen des Sockels oder um dessen Ursprung angegeben, und die Messwerte sagen nicht, wo der Sensor ist.</translation>
    </message>
    <message>
        <source>the torque is about the base&apos;s origin, but where the sensor was is not recorded.</source>
        <translation>das Moment ist um den Ursprung des Sockels angegeben, aber wo der Sensor war, ist nicht aufgezeichnet.</translation>
    </message>
    <message>
        <source>Record px, py, pz or the joint angles.</source>
        <translation>Zeichnen Sie px, py, pz oder die Gelenkwinkel auf.</translation>
    </message>
    <message>
        <source>the wrench is stated in the base&apos;s axes or about its origin, and there is no robot to show where the sensor was.</source>
        <translation>Kraft und Moment sind in den Achsen des Sockels oder um dessen Ursprung angegeben, und kein Roboter sagt, wo der Sensor war.</translation>
    </message>
    <message>
        <source>there are {} joints, the robot &quot;{}&quot; has {}.</source>
        <translation>es gibt {} Gelenke, der Roboter „{}“ hat {}.</translation>
    </message>
    <message>
        <source>column &quot;{}&quot; is in another unit than the one stated, {}.</source>
        <translation>die Spalte „{}“ hat eine andere Einheit als die angegebene, {}.</translation>
    </message>
    <message>
        <source>Convert it to {} and name it {}, or state the unit of all such columns in the setup file.</source>
        <translation>Rechnen Sie sie in {} um und nennen Sie sie {}, oder geben Sie die Einheit aller solchen Spalten in der Aufbaudatei an.</translation>
    </message>
    <message>
        <source>{}, or a number above zero ({} in one of it)</source>
        <translation>{} oder eine Zahl über null sein ({} in einer davon)</translation>
    </message>
    <message>
        <source>&quot;sensor&quot;, &quot;base&quot; or three numbers [m] from the sensor&apos;s origin in its axes</source>
        <translation>&quot;sensor&quot;, &quot;base&quot; oder drei Zahlen [m] vom Ursprung des Sensors in seinen Achsen</translation>
    </message>
    <message>
        <source>a point within {} m of the sensor (in metres, not millimetres)</source>
        <translation>ein Punkt bis {} m vom Sensor (in Metern, nicht Millimetern)</translation>
    </message>
    <message>
        <source>{} is {:.6g}, more than a turn in radians: degrees?</source>
        <translation>{} ist {:.6g}, im Bogenmaß mehr als eine Umdrehung: Grad?</translation>
    </message>
    <message>
        <source>{} is {:.6g}: no arm reaches that many metres from its base. Millimetres?</source>
        <translation>{} ist {:.6g}: Kein Arm reicht so viele Meter weit von seinem Sockel. Millimeter?</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>must be {}, not {}.</source>
        <translation>muss {} sein, nicht {}.</translation>
    </message>
    <message>
        <source>The centre of mass would be {:.2f} m from the sensor. If the tool is not that long, force and torque are in other units than the setup file says.</source>
        <translation>Der Schwerpunkt läge {:.2f} m vom Sensor entfernt. Ist das Werkzeug nicht so lang, haben Kraft und Drehmoment andere Einheiten, als die Aufbaudatei sagt.</translation>
    </message>
    <message>
        <source>Check force_unit and torque_unit in the setup file.</source>
        <translation>Prüfen Sie force_unit und torque_unit in der Aufbaudatei.</translation>
    </message>
    <message>
        <source>A load of {:.0f} kg is more than this arm carries: the force&apos;s unit is probably not what the setup file says.</source>
        <translation>Eine Last von {:.0f} kg trägt dieser Arm nicht: Die Einheit der Kraft ist wohl nicht die der Aufbaudatei.</translation>
    </message>
    <message>
        <source>State force_unit in the setup file.</source>
        <translation>Geben Sie force_unit in der Aufbaudatei an.</translation>
    </message>
    <message>
        <source>The centre of mass lies {:.0f} mm behind the sensor, in the arm. Standing poses cannot distinguish that from a torque with the opposite sign, or one taken about another point.</source>
        <translation>Der Schwerpunkt liegt {:.0f} mm hinter dem Sensor, im Arm. Stehende Posen können das nicht von einem Drehmoment mit umgekehrtem Vorzeichen oder um einen anderen Punkt unterscheiden.</translation>
    </message>
    <message>
        <source>Check the torque&apos;s sign and reference point, or record a motion with brisk turns.</source>
        <translation>Prüfen Sie Vorzeichen und Bezugspunkt des Drehmoments, oder nehmen Sie eine Bewegung mit zügigen Drehungen auf.</translation>
    </message>
    <message>
        <source>The readings follow the stated conventions.</source>
        <translation>Die Messwerte folgen den angegebenen Konventionen.</translation>
    </message>
    <message>
        <source>The readings fit the stated conventions, and others as well.</source>
        <translation>Die Messwerte passen zu den angegebenen Konventionen, und auch zu anderen.</translation>
    </message>
    <message>
        <source>The stated conventions do not fit, and this recording cannot show which ones do. Likeliest: {}</source>
        <translation>Die angegebenen Konventionen passen nicht, und diese Aufnahme kann nicht zeigen, welche es tun. Am wahrscheinlichsten: {}</translation>
    </message>
    <message>
        <source>No rigid payload explains the readings, under the stated conventions or any other usual ones.</source>
        <translation>Keine starre Last erklärt die Messwerte, weder mit den angegebenen Konventionen noch mit anderen üblichen.</translation>
    </message>
    <message>
        <source>Look for contact, a cable, or a sensor that was zeroed during the recording.</source>
        <translation>Suchen Sie nach Kontakt, einem Kabel oder einem Sensor, der während der Aufnahme genullt wurde.</translation>
    </message>
    <message>
        <source>A motion with brisk turns in all directions would decide.</source>
        <translation>Eine Bewegung mit zügigen Drehungen in alle Richtungen würde es entscheiden.</translation>
    </message>
    <message>
        <source>A longer motion that tilts and turns the tool in all directions would decide.</source>
        <translation>Eine längere Bewegung, die das Werkzeug in alle Richtungen kippt und dreht, würde es entscheiden.</translation>
    </message>
    <message>
        <source>Forces are in {}, torques in {}.</source>
        <translation>Kräfte sind in {} angegeben, Drehmomente in {}.</translation>
    </message>
    <message>
        <source>The signs are those of the load on the sensor, not of the sensor on the load.</source>
        <translation>Die Vorzeichen sind die der Last auf den Sensor, nicht die des Sensors auf die Last.</translation>
    </message>
    <message>
        <source>The signs are those of the sensor on the load, not of the load on the sensor.</source>
        <translation>Die Vorzeichen sind die des Sensors auf die Last, nicht die der Last auf den Sensor.</translation>
    </message>
    <message>
        <source>The torque has the opposite sign to the force.</source>
        <translation>Das Drehmoment hat das umgekehrte Vorzeichen der Kraft.</translation>
    </message>
    <message>
        <source>The torque has the same sign as the force.</source>
        <translation>Das Drehmoment hat das gleiche Vorzeichen wie die Kraft.</translation>
    </message>
    <message>
        <source>The torque comes first, then the force.</source>
        <translation>Das Drehmoment kommt zuerst, dann die Kraft.</translation>
    </message>
    <message>
        <source>The force comes first, then the torque.</source>
        <translation>Die Kraft kommt zuerst, dann das Drehmoment.</translation>
    </message>
    <message>
        <source>The force is given in the robot&apos;s base axes, not the sensor&apos;s.</source>
        <translation>Die Kraft ist in den Achsen der Roboterbasis angegeben, nicht in denen des Sensors.</translation>
    </message>
    <message>
        <source>The force is given in the sensor&apos;s axes, not the robot&apos;s base axes.</source>
        <translation>Die Kraft ist in den Achsen des Sensors angegeben, nicht in denen der Roboterbasis.</translation>
    </message>
    <message>
        <source>The torque is taken about the origin of the robot&apos;s base.</source>
        <translation>Das Drehmoment bezieht sich auf den Ursprung der Roboterbasis.</translation>
    </message>
    <message>
        <source>The torque is taken about the sensor&apos;s origin.</source>
        <translation>Das Drehmoment bezieht sich auf den Ursprung des Sensors.</translation>
    </message>
    <message>
        <source>The torque is taken about a point {:.0f} mm from the sensor&apos;s origin.</source>
        <translation>Das Drehmoment bezieht sich auf einen Punkt, der {:.0f} mm vom Ursprung des Sensors entfernt ist.</translation>
    </message>
    <message>
        <source>No axis has the wrong sign.</source>
        <translation>Keine Achse hat das falsche Vorzeichen.</translation>
    </message>
    <message>
        <source>Force and torque along {} have the wrong sign.</source>
        <translation>Kraft und Drehmoment entlang {} haben das falsche Vorzeichen.</translation>
    </message>
    <message>
        <source>The sensor is mounted {:.0f} degrees away from where the setup file has it.</source>
        <translation>Der Sensor ist um {:.0f} Grad anders befestigt, als die Aufbaudatei sagt.</translation>
    </message>
    <message>
        <source>Gravity points the other way in the robot&apos;s base: it hangs from the ceiling, or stands upright.</source>
        <translation>Die Schwerkraft zeigt in der Roboterbasis in die andere Richtung: Der Roboter hängt an der Decke oder steht aufrecht.</translation>
    </message>
    <message>
        <source>Gravity points {:.0f} degrees away from what the setup file says: the base is mounted differently.</source>
        <translation>Die Schwerkraft zeigt um {:.0f} Grad anders, als die Aufbaudatei sagt: Die Basis ist anders befestigt.</translation>
    </message>
    <message>
        <source>The poses are those of the base in the sensor&apos;s frame.</source>
        <translation>Die Posen sind die der Basis im Koordinatensystem des Sensors.</translation>
    </message>
    <message>
        <source>The poses are those of the sensor in the base frame.</source>
        <translation>Die Posen sind die des Sensors im Koordinatensystem der Basis.</translation>
    </message>
    <message>
        <source>The quaternions have w first.</source>
        <translation>Die Quaternionen haben w zuerst.</translation>
    </message>
    <message>
        <source>The quaternions have w last.</source>
        <translation>Die Quaternionen haben w zuletzt.</translation>
    </message>
    <message>
        <source>Check which sign the driver reports at rest: the weight of the load, or the force that carries it.</source>
        <translation>Prüfen Sie, welches Vorzeichen der Treiber in Ruhe meldet: das Gewicht der Last oder die Kraft, die sie trägt.</translation>
    </message>
    <message>
        <source>Check whether the driver or your own code turns the sign of forces or torques alone.</source>
        <translation>Prüfen Sie, ob der Treiber oder eigener Code das Vorzeichen nur der Kräfte oder nur der Drehmomente umkehrt.</translation>
    </message>
    <message>
        <source>Check the order of the columns: spatial vectors often have the torque first.</source>
        <translation>Prüfen Sie die Reihenfolge der Spalten: Räumliche Vektoren haben oft das Drehmoment zuerst.</translation>
    </message>
    <message>
        <source>Check in which frame the controller reports the wrench (UR: actual_TCP_force is in base axes).</source>
        <translation>Prüfen Sie, in welchen Achsen die Steuerung Kraft und Drehmoment meldet (UR: actual_TCP_force in denen der Basis).</translation>
    </message>
    <message>
        <source>Check which point the controller takes torques about (sensor, TCP, flange or base).</source>
        <translation>Prüfen Sie, auf welchen Punkt die Steuerung Drehmomente bezieht (Sensor, TCP, Flansch oder Basis).</translation>
    </message>
    <message>
        <source>Check whether the driver uses a left-handed frame or changes the sign of one axis.</source>
        <translation>Prüfen Sie, ob der Treiber ein linkshändiges System benutzt oder das Vorzeichen einer Achse ändert.</translation>
    </message>
    <message>
        <source>Check the mounting angle of the sensor, and the frame that its driver reports in.</source>
        <translation>Prüfen Sie den Winkel, in dem der Sensor befestigt ist, und die Achsen, in denen sein Treiber meldet.</translation>
    </message>
    <message>
        <source>Check the units on the sensor&apos;s configuration page or in its calibration file.</source>
        <translation>Prüfen Sie die Einheiten auf der Einstellungsseite des Sensors oder in seiner Kalibrierdatei.</translation>
    </message>
    <message>
        <source>Check how the base is mounted (floor, wall, ceiling) and the direction of gravity.</source>
        <translation>Prüfen Sie, wie die Basis befestigt ist (Boden, Wand, Decke), und die Richtung der Schwerkraft.</translation>
    </message>
    <message>
        <source>Check whether the logged transform is sensor to base or base to sensor.</source>
        <translation>Prüfen Sie, ob die aufgezeichnete Transformation vom Sensor zur Basis oder von der Basis zum Sensor führt.</translation>
    </message>
    <message>
        <source>Check the order of the quaternion&apos;s components (Eigen&apos;s constructor and MuJoCo: w first; ROS: w last).</source>
        <translation>Prüfen Sie die Reihenfolge der Quaternionen (Eigens Konstruktor und MuJoCo: w zuerst; ROS: w zuletzt).</translation>
    </message>
    <message>
        <source>Causes are checked on motions only, not on standing poses.</source>
        <translation>Ursachen werden nur an Bewegungen geprüft, nicht an stehenden Posen.</translation>
    </message>
    <message>
        <source>{} poses are too few to look for causes; record at least {}.</source>
        <translation>{} Posen sind zu wenige, um nach Ursachen zu suchen; nehmen Sie mindestens {} auf.</translation>
    </message>
    <message>
        <source>Looking at conventions</source>
        <translation>Konventionen werden geprüft</translation>
    </message>
    <message>
        <source>how the tool is turned</source>
        <translation>der Drehung des Werkzeugs</translation>
    </message>
    <message>
        <source>Other conventions fit as well.</source>
        <translation>Andere Konventionen passen ebenso.</translation>
    </message>
    <message>
        <source>Standing poses cannot determine: inertia, delays, friction, a gain that all channels share, a pull straight up or down, or the zero of the first joint.</source>
        <translation>Stehende Posen zeigen nicht: Trägheit, Verzögerungen, Reibung, eine allen Kanälen gemeinsame Verstärkung, einen Zug genau nach oben oder unten und die Nullstellung des ersten Gelenks.</translation>
    </message>
    <message>
        <source>Record a motion with brisk turns for these.</source>
        <translation>Nehmen Sie dafür eine Bewegung mit zügigen Drehungen auf.</translation>
    </message>
    <message>
        <source>The sensor&apos;s zero drifts: {} by {} {} from each pose to the next.</source>
        <translation>Der Nullpunkt des Sensors driftet: {} um {} {} von einer Pose zur nächsten.</translation>
    </message>
    <message>
        <source>After pose {} the sensor&apos;s zero jumped by {} N and {} N m.</source>
        <translation>Nach Pose {} sprang der Nullpunkt des Sensors um {} N und {} N m.</translation>
    </message>
    <message>
        <source>After pose {} the load was {} g heavier.</source>
        <translation>Nach Pose {} war die Last {} g schwerer.</translation>
    </message>
    <message>
        <source>After pose {} the load was {} g lighter.</source>
        <translation>Nach Pose {} war die Last {} g leichter.</translation>
    </message>
    <message>
        <source>These poses do not fit the others, by up to {} N: {}. The tool touched something, or moved.</source>
        <translation>Diese Posen passen nicht zu den anderen, um bis zu {} N: {}. Das Werkzeug berührte etwas oder bewegte sich.</translation>
    </message>
    <message>
        <source>Something pulls at the tool. How much of that goes straight up or down is unknown, and so is the mass, to {:.2g} kg.</source>
        <translation>Etwas zieht am Werkzeug. Wie viel davon genau nach oben oder unten geht, ist unbekannt, und damit die Masse, auf {:.2g} kg.</translation>
    </message>
    <message>
        <source>Take the pull away and record the poses again.</source>
        <translation>Beseitigen Sie den Zug und nehmen Sie die Posen noch einmal auf.</translation>
    </message>
    <message>
        <source>Estimate with --conventions suggested, or write {} into the setup file.</source>
        <translation>Schätzen Sie mit --conventions suggested, oder schreiben Sie {} in die Aufbaudatei.</translation>
    </message>
    <message>
        <source>To keep that, write {} into the setup file.</source>
        <translation>Um dabei zu bleiben, schreiben Sie {} in die Aufbaudatei.</translation>
    </message>
    <message>
        <source>Recording {}:</source>
        <translation>Aufnahme {}:</translation>
    </message>
    <message>
        <source>Look at its findings, or leave it out.</source>
        <translation>Sehen Sie sich ihre Befunde an, oder lassen Sie sie weg.</translation>
    </message>
    <message>
        <source>The weight cannot be determined from these readings as they are interpreted. {}</source>
        <translation>Aus diesen Messwerten lässt sich, so wie sie verstanden werden, kein Gewicht angeben. {}</translation>
    </message>
    <message>
        <source>As stated, the tool would weigh {:.2f} kg.</source>
        <translation>Wie angegeben würde das Werkzeug {:.2f} kg wiegen.</translation>
    </message>
    <message>
        <source>The fit gives a negative mass.</source>
        <translation>Die Anpassung ergibt eine negative Masse.</translation>
    </message>
    <message>
        <source>Check the sign of the wrench and which column is which.</source>
        <translation>Prüfen Sie das Vorzeichen von Kraft und Moment und die Zuordnung der Spalten.</translation>
    </message>
    <message>
        <source>The solver did not reach a solution: {}</source>
        <translation>Der Löser hat keine Lösung erreicht: {}</translation>
    </message>
    <message>
        <source>Record a longer motion that tilts and turns the tool.</source>
        <translation>Nehmen Sie eine längere Bewegung auf, die das Werkzeug neigt und dreht.</translation>
    </message>
    <message>
        <source>The value of the mass is outside its own interval.</source>
        <translation>Der Wert der Masse liegt außerhalb seines eigenen Bereichs.</translation>
    </message>
    <message>
        <source>Look for contact, a cable, or a sensor that was zeroed during the recording; &apos;heft diagnose&apos; names the cause.</source>
        <translation>Suchen Sie nach Berührung, einem Kabel oder einem Sensor, der während der Aufnahme genullt wurde; „heft diagnose“ nennt die Ursache.</translation>
    </message>
    <message>
        <source>This recording fits the stated conventions and others equally well.</source>
        <translation>Diese Aufnahme kann die angegebenen Konventionen nicht von anderen unterscheiden.</translation>
    </message>
    <message>
        <source>Recording {} was left out:</source>
        <translation>Aufnahme {} wurde weggelassen:</translation>
    </message>
    <message>
        <source>Look for causes: a turned sensor, a tilted base and a joint&apos;s zero look alike.</source>
        <translation>Suchen Sie nach Ursachen: Ein verdrehter Sensor, eine geneigte Basis und der Nullpunkt eines Gelenks sehen gleich aus.</translation>
    </message>
    <message>
        <source>Look for causes: a gain of force or torque, and a sensor beside its place, look like this.</source>
        <translation>Suchen Sie nach Ursachen: Ein Verstärkungsfehler von Kraft oder Drehmoment und ein Sensor neben seinem Platz sehen so aus.</translation>
    </message>
    <message>
        <source>Record more poses, tilted to all sides.</source>
        <translation>Nehmen Sie mehr Haltungen auf, nach allen Seiten geneigt.</translation>
    </message>
    <message>
        <source>This recording fits this interpretation and others equally well.</source>
        <translation>Diese Aufnahme kann diese Lesart nicht von anderen unterscheiden.</translation>
    </message>
    <message>
        <source>The controller was set to {:.3f} kg ({}), {:.3f} kg {} than estimated.</source>
        <translation>In der Steuerung waren {:.3f} kg eingestellt ({}), {:.3f} kg {} als geschätzt.</translation>
    </message>
    <message>
        <source>less</source>
        <translation>weniger</translation>
    </message>
    <message>
        <source>more</source>
        <translation>mehr</translation>
    </message>
    <message>
        <source>Its centre of mass is set {:.1f} mm from the estimated one.</source>
        <translation>Ihr Schwerpunkt liegt {:.1f} mm neben dem geschätzten.</translation>
    </message>
    <message>
        <source>The controller&apos;s values include what sits between flange and sensor, the estimate does not: &apos;heft export --add&apos; adds it.</source>
        <translation>Die Werte der Steuerung enthalten, was zwischen Flansch und Sensor sitzt, die Schätzung nicht: „heft export --add“ fügt es hinzu.</translation>
    </message>
    <message>
        <source>This format has no inertia: it is left out.</source>
        <translation>Dieses Format kennt keine Trägheit: Sie wird weggelassen.</translation>
    </message>
    <message>
        <source>The sensor&apos;s frame is called ft_sensor.</source>
        <translation>Das Koordinatensystem des Sensors heißt in der Datei ft_sensor.</translation>
    </message>
    <message>
        <source>A payload without an estimate has no bias; zeros are written.</source>
        <translation>Zu einer Last ohne Schätzung gehört kein Nullpunkt; es werden Nullen geschrieben.</translation>
    </message>
    <message>
        <source>Zero the sensor with the tool off.</source>
        <translation>Stellen Sie den Sensor ohne Werkzeug auf null.</translation>
    </message>
    <message>
        <source>that the centre of mass counts from the flange</source>
        <translation>dass der Schwerpunkt vom Flansch aus zählt</translation>
    </message>
    <message>
        <source>the link &quot;{}&quot; moves against &quot;{}&quot;, which carries the sensor.</source>
        <translation>das Glied „{}“ bewegt sich gegen „{}“, das den Sensor trägt.</translation>
    </message>
    <message>
        <source>Name a link behind the last joint.</source>
        <translation>Nennen Sie ein Glied hinter dem letzten Gelenk.</translation>
    </message>
    <message>
        <source>there is no link &quot;{}&quot;.</source>
        <translation>es gibt kein Glied „{}“.</translation>
    </message>
    <message>
        <source>Name one of: {}.</source>
        <translation>Nennen Sie eines von: {}.</translation>
    </message>
    <message>
        <source>The URDF has no link that the sensor is known to be mounted on, so &quot;{}&quot; was taken for the flange.</source>
        <translation>Die URDF hat kein Glied, an dem der Sensor bekanntermaßen sitzt; „{}“ wurde daher als Flansch genommen.</translation>
    </message>
    <message>
        <source>Check that its axes are the flange&apos;s.</source>
        <translation>Prüfen Sie, ob seine Achsen die des Flanschs sind.</translation>
    </message>
    <message>
        <source>If that was the arm&apos;s own mass, put the payload on a link of its own.</source>
        <translation>War das die Masse des Arms selbst, geben Sie der Last ein eigenes Glied.</translation>
    </message>
    <message>
        <source>the objects</source>
        <translation>den Objekten</translation>
    </message>
    <message>
        <source>{} comes as {}, which is not read: let the bridge send ROS messages (cdr, ros1) or JSON.</source>
        <translation>{} kommt als {}, was nicht gelesen wird: Lassen Sie die Brücke ROS-Nachrichten (cdr, ros1) oder JSON senden.</translation>
    </message>
    <message>
        <source>{} describes its messages as {}, which is not read: let the bridge send ros2msg or JSON.</source>
        <translation>{} beschreibt seine Nachrichten als {}, was nicht gelesen wird: Lassen Sie die Brücke ros2msg oder JSON senden.</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>The objects have neither joint angles or a pose, nor fx, fy, fz, tx, ty, tz.</source>
        <translation>Die Objekte haben weder Gelenkwinkel oder eine Pose noch fx, fy, fz, tx, ty, tz.</translation>
    </message>
    <message>
        <source>{}:{} says: {}</source>
        <translation>{}:{} meldet: {}</translation>
    </message>
    <message>
        <source>{}:{} does not speak version 2 of RTDE: its software is too old.</source>
        <translation>{}:{} spricht nicht Version 2 von RTDE: Die Software ist zu alt.</translation>
    </message>
    <message>
        <source>{}:{} does not send {}.</source>
        <translation>{}:{} sendet {} nicht.</translation>
    </message>
    <message>
        <source>{}:{} does not accept the outputs that are asked for.</source>
        <translation>{}:{} nimmt die Liste der gewünschten Ausgaben nicht an.</translation>
    </message>
    <message>
        <source>{}:{} does not start to send.</source>
        <translation>{}:{} beginnt nicht zu senden.</translation>
    </message>
    <message>
        <source>Neither joint angles, a pose nor a wrench arrived: motion and wrench are both needed.</source>
        <translation>Es kamen weder Gelenkwinkel noch eine Pose noch Kräfte an: Bewegung und Kräfte werden beide gebraucht.</translation>
    </message>
    <message>
        <source>The wrench arrives, but no joint angles and no pose: add the robot as a second source, such as foxglove:HOST, rosbridge:HOST or rtde:HOST.</source>
        <translation>Kräfte kommen an, aber weder Gelenkwinkel noch eine Pose: Nenn den Roboter als zweite Quelle, etwa foxglove:HOST, rosbridge:HOST oder rtde:HOST.</translation>
    </message>
    <message>
        <source>Joint angles or poses arrive, but no wrench: add the sensor as a second source, such as rdt:HOST.</source>
        <translation>Gelenkwinkel oder Posen kommen an, aber keine Kräfte: Nenn den Sensor als zweite Quelle, etwa rdt:HOST.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; names no file.</source>
        <translation>„{}“ nennt keine Datei.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is a xacro file.</source>
        <translation>„{}“ ist eine xacro-Datei.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; was not found in {} or a folder above it, nor by ROS_PACKAGE_PATH or AMENT_PREFIX_PATH.</source>
        <translation>„{}“ fand sich weder in {} oder einem Ordner darüber noch über ROS_PACKAGE_PATH oder AMENT_PREFIX_PATH.</translation>
    </message>
    <message>
        <source>Source the workspace that holds the package, or give the path of the URDF.</source>
        <translation>Lade den Workspace, der das Paket enthält, oder gib den Pfad der URDF an.</translation>
    </message>
    <message>
        <source>Choose a larger measuring range of the sensor.</source>
        <translation>Wählen Sie einen größeren Messbereich des Sensors.</translation>
    </message>
    <message>
        <source>The recorded motion is noisy; it was smoothed to {:.0f} Hz, and the wrench with it.</source>
        <translation>Die aufgezeichnete Bewegung rauscht; sie wurde auf {:.0f} Hz geglättet, Kraft und Moment ebenso.</translation>
    </message>
    <message>
        <source>Let the source stamp its samples when they are measured, not when they are sent.</source>
        <translation>Lassen Sie die Quelle ihre Werte beim Messen stempeln, nicht beim Senden.</translation>
    </message>
    <message>
        <source>A rigid tool does not describe the readings yet, so no number is shown.</source>
        <translation>Ein starres Werkzeug beschreibt die Messwerte noch nicht; deshalb wird keine Zahl genannt.</translation>
    </message>
    <message>
        <source>Check the time stamps, the wrench&apos;s sign and axes, and that nothing touches the tool.</source>
        <translation>Prüfen Sie die Zeitstempel, Vorzeichen und Achsen von Kraft und Moment, und dass nichts das Werkzeug berührt.</translation>
    </message>
    <message>
        <source>{:.2f} to {:.2f} s</source>
        <translation>{:.2f} bis {:.2f} s</translation>
    </message>
    <message>
        <source>{}: {}</source>
        <translation>{}: {}</translation>
    </message>
    <message>
        <source>Nothing was recorded here.</source>
        <translation>Hier wurde nichts aufgezeichnet.</translation>
    </message>
    <message>
        <source>{} is frozen here while others go on: it was not measured.</source>
        <translation>{} steht hier still, während andere Kanäle weiterlaufen: Der Kanal wurde nicht gemessen.</translation>
    </message>
    <message>
        <source>The posture is frozen here and jumps afterwards: the robot sent nothing new.</source>
        <translation>Die Haltung steht hier still und springt danach: Der Roboter hat nichts Neues gesendet.</translation>
    </message>
    <message>
        <source>Motion late</source>
        <translation>Bewegung verspätet</translation>
    </message>
    <message>
        <source>should be three numbers</source>
        <translation>sollte drei Zahlen enthalten</translation>
    </message>
    <message>
        <source>State it in a map file, for instance {{&quot;offset_s&quot;: {{{}}}}} (seconds added to its times).</source>
        <translation>Geben Sie es in einer Zuordnungsdatei an, zum Beispiel {{&quot;offset_s&quot;: {{{}}}}} (Sekunden, die zu den Zeiten addiert werden).</translation>
    </message>
    <message>
        <source>If the file has no clock, state its rate with --rate HZ.</source>
        <translation>Hat die Datei keine Uhr, nennen Sie ihre Rate mit --rate HZ.</translation>
    </message>
    <message>
        <source>Name it with --robot, or in the setup file: &quot;robot&quot;: &quot;panda&quot; or the path of a URDF.</source>
        <translation>Nennen Sie ihn mit --robot oder in der Aufbaudatei: &quot;robot&quot;: &quot;panda&quot; oder den Pfad einer URDF-Datei.</translation>
    </message>
    <message>
        <source>The times of /{} were taken from /{}.</source>
        <translation>Die Zeiten von /{} stammen aus /{}.</translation>
    </message>
    <message>
        <source>The datasets of {} rows in /{} have no dataset of times beside them.</source>
        <translation>Bei den Datensätzen mit {} Zeilen in /{} steht kein Datensatz mit Zeiten.</translation>
    </message>
    <message>
        <source>pose of a UR with a rotation vector</source>
        <translation>Pose eines UR mit Drehvektor</translation>
    </message>
    <message>
        <source>pose of a KUKA: mm, and A, B, C in degrees</source>
        <translation>Pose eines KUKA: mm, und A, B, C in Grad</translation>
    </message>
    <message>
        <source>rotation vector</source>
        <translation>Drehvektor</translation>
    </message>
    <message>
        <source>The file of {} kB unpacks to more than 64 times its size and 1 GB; the rest was not read.</source>
        <translation>Die Datei von {} kB wird entpackt größer als das 64-Fache ihrer Größe und 1 GB; der Rest wurde nicht gelesen.</translation>
    </message>
    <message>
        <source>filter {} of HDF5, which this machine does not have</source>
        <translation>dem HDF5-Filter {}, den dieser Rechner nicht hat</translation>
    </message>
    <message>
        <source>{}, which this machine cannot unpack (Debian: {})</source>
        <translation>{}, was dieser Rechner nicht entpacken kann (Debian: {})</translation>
    </message>
    <message>
        <source>datasets of the file are packed with {}.</source>
        <translation>Datensätze der Datei sind gepackt mit {}.</translation>
    </message>
    <message>
        <source>Install that package, or rewrite the file with &quot;h5repack -f GZIP=4 IN OUT&quot; where the filter is at hand.</source>
        <translation>Installieren Sie dieses Paket, oder schreiben Sie die Datei dort, wo es den Filter gibt, mit „h5repack -f GZIP=4 IN OUT“ neu.</translation>
    </message>
    <message>
        <source>Units were taken from the columns&apos; names ({}{}).</source>
        <translation>Einheiten wurden den Namen der Spalten entnommen ({}{}).</translation>
    </message>
    <message>
        <source>UR&apos;s actual_TCP_force is in the robot&apos;s base axes, about the TCP, and without the payload that the controller has configured; it was read so.</source>
        <translation>URs actual_TCP_force steht in den Achsen der Roboterbasis, gilt um den TCP und enthält die Last nicht, die in der Steuerung eingestellt ist; so wurde sie gelesen.</translation>
    </message>
    <message>
        <source>State sensor.wrench_point in the setup file if the TCP is not at the sensor, or record ft_raw_wrench.</source>
        <translation>Geben Sie sensor.wrench_point in der Aufbaudatei an, wenn der TCP nicht am Sensor liegt, oder zeichnen Sie ft_raw_wrench auf.</translation>
    </message>
    <message>
        <source>this is a Parquet or Arrow file, for which Debian has no library.</source>
        <translation>dies ist eine Parquet- oder Arrow-Datei, für die Debian keine Bibliothek hat.</translation>
    </message>
    <message>
        <source>Convert it, for instance with python3 -c &quot;import pandas; pandas.{}(&apos;{}&apos;).to_csv(&apos;{}.csv&apos;, index=False)&quot;.</source>
        <translation>Wandeln Sie sie um, zum Beispiel mit python3 -c &quot;import pandas; pandas.{}(&apos;{}&apos;).to_csv(&apos;{}.csv&apos;, index=False)&quot;.</translation>
    </message>
    <message>
        <source>{} has no clock: nothing in the file gives its times.</source>
        <translation>{} hat keine Uhr: Nichts in der Datei nennt die Zeiten.</translation>
    </message>
    <message>
        <source>an offset is stated for &quot;{}&quot;, which is not there.</source>
        <translation>ein Versatz ist für „{}“ angegeben, was es nicht gibt.</translation>
    </message>
    <message>
        <source>What was chosen is {}.</source>
        <translation>Gewählt wurde {}.</translation>
    </message>
    <message>
        <source>The position is</source>
        <translation>Die Position ist</translation>
    </message>
    <message>
        <source>{} of {} samples of {} are all zeros between others: another publisher sends there, too. They were left out.</source>
        <translation>{} von {} Werten von {} sind lauter Nullen zwischen anderen: Dort sendet noch jemand. Sie wurden weggelassen.</translation>
    </message>
    <message>
        <source>{} of {} samples of {} do not fit the others: another publisher sends there, too ({}). The one that moves was taken.</source>
        <translation>{} von {} Werten von {} passen nicht zu den anderen: Dort sendet noch jemand ({}). Genommen wurde, was sich bewegt.</translation>
    </message>
    <message>
        <source>Split the recording there, or record one source only.</source>
        <translation>Teilen Sie die Aufnahme dort, oder zeichnen Sie nur eine Quelle auf.</translation>
    </message>
    <message>
        <source>{} of {} samples of {} have none of these joints: another publisher sends there, too{}. They were left out.</source>
        <translation>{} von {} Werten von {} haben keines dieser Gelenke: Dort sendet noch jemand{}. Sie wurden weggelassen.</translation>
    </message>
    <message>
        <source>The force of {} does not follow the motion of {} within half a second, but does when shifted by {:.3f} s (+- {:.3f} s; the motion then explains {:.0f} % of the force); nothing was shifted.</source>
        <translation>Die Kraft von {} folgt der Bewegung von {} innerhalb einer halben Sekunde nicht, wohl aber um {:.3f} s verschoben (± {:.3f} s; die Bewegung erklärt dann {:.0f} % der Kraft); verschoben wurde nichts.</translation>
    </message>
    <message>
        <source>The recorder lagged, or one clock is wrong.</source>
        <translation>Der Aufzeichner hing nach, oder eine Uhr geht falsch.</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>there is no demonstration &quot;{}&quot;.</source>
        <translation>es gibt keine Vorführung „{}“.</translation>
    </message>
    <message>
        <source>The file holds {} demonstrations; {} was read, not {}{}.</source>
        <translation>Die Datei enthält {} Vorführungen; gelesen wurde {}, nicht {}{}.</translation>
    </message>
    <message>
        <source>A map file is a JSON object with use, scale, offset_s, join, pose_of, clock, rate_hz, sensor, {}.</source>
        <translation>Eine Zuordnungsdatei ist ein JSON-Objekt mit use, scale, offset_s, join, pose_of, clock, rate_hz, sensor, {}.</translation>
    </message>
    <message>
        <source>a cell array</source>
        <translation>ein Cell-Array</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>a sparse matrix</source>
        <translation>eine dünn besetzte Matrix</translation>
    </message>
    <message>
        <source>a table or another object</source>
        <translation>eine Tabelle oder ein anderes Objekt</translation>
    </message>
    <message>
        <source>this MATLAB file cannot be opened: it is cut off or damaged.</source>
        <translation>diese MATLAB-Datei lässt sich nicht öffnen: Sie ist abgeschnitten oder beschädigt.</translation>
    </message>
    <message>
        <source>Save it again, for instance with save(&apos;FILE&apos;, &apos;-v7&apos;).</source>
        <translation>Speichern Sie sie noch einmal, zum Beispiel mit save(&apos;FILE&apos;, &apos;-v7&apos;).</translation>
    </message>
    <message>
        <source>its encoding &quot;{}&quot; is none of those that Heft reads (ros1, cdr, json)</source>
        <translation>seine Kodierung „{}“ gehört nicht zu denen, die Heft liest (ros1, cdr, json)</translation>
    </message>
    <message>
        <source>its schema is in &quot;{}&quot;, and Heft does not know the type by itself</source>
        <translation>sein Schema ist in „{}“, und den Typ kennt Heft nicht von selbst</translation>
    </message>
    <message>
        <source>{} messages on {} have times before 1897 or after 2043 and were left out.</source>
        <translation>{} Nachrichten auf {} haben Zeiten vor 1897 oder nach 2043 und wurden weggelassen.</translation>
    </message>
    <message>
        <source>{} of {} messages on {} are in XCDR 2 or as parameter lists, not in plain CDR, and were left out.</source>
        <translation>{} von {} Nachrichten auf {} sind in XCDR 2 oder als Parameterlisten geschrieben, nicht in einfachem CDR, und wurden weggelassen.</translation>
    </message>
    <message>
        <source>Topic {} cannot be read: {}.</source>
        <translation>Thema {} kann nicht gelesen werden: {}.</translation>
    </message>
    <message>
        <source>a structure in a structure</source>
        <translation>eine Struktur in einer Struktur</translation>
    </message>
    <message>
        <source>pickled Python objects</source>
        <translation>gepickelte Python-Objekte</translation>
    </message>
    <message>
        <source>no numbers</source>
        <translation>keine Zahlen</translation>
    </message>
    <message>
        <source>The first row looks like data, not like names; the columns are called column1 to column{}.</source>
        <translation>Die erste Zeile sieht nach Daten aus, nicht nach Namen; die Spalten heißen column1 bis column{}.</translation>
    </message>
    <message>
        <source>Put a row of names above it, or name the columns by their numbers, for instance with --use fx=column2.</source>
        <translation>Setzen Sie eine Zeile mit Namen darüber, oder nennen Sie die Spalten nach ihrer Nummer, zum Beispiel mit --use fx=column2.</translation>
    </message>
    <message>
        <source>The text is UTF-16 and was read as such.</source>
        <translation>Der Text ist UTF-16 und wurde so gelesen.</translation>
    </message>
    <message>
        <source>Decimal commas were read as points.</source>
        <translation>Dezimalkommas wurden als Punkte gelesen.</translation>
    </message>
    <message>
        <source>{} lines above the names of the columns were skipped.</source>
        <translation>{} Zeilen über den Namen der Spalten wurden übersprungen.</translation>
    </message>
    <message>
        <source>The row below the names was read as the columns&apos; units.</source>
        <translation>Die Zeile unter den Namen wurde als Einheiten der Spalten gelesen.</translation>
    </message>
    <message>
        <source>State sensor.mount in the setup file.</source>
        <translation>Geben Sie sensor.mount in der Aufbaudatei an.</translation>
    </message>
    <message>
        <source>the first row looks like data, not like column names.</source>
        <translation>die erste Zeile sieht nach Daten aus, nicht nach Namen von Spalten.</translation>
    </message>
    <message>
        <source>Write time in seconds, not microseconds.</source>
        <translation>Schreiben Sie die Zeit in Sekunden, nicht in Mikrosekunden.</translation>
    </message>
    <message>
        <source>{} has too little free motion to check a cause on it.</source>
        <translation>In {} ist kein Stück lange genug ohne Berührung, um eine Ursache daran zu prüfen.</translation>
    </message>
    <message>
        <source>Sensor zero jumped (bias step)</source>
        <translation>Sensornull gesprungen (Nullpunktsprung)</translation>
    </message>
    <message>
        <source>Sensor zero drifts (bias drift)</source>
        <translation>Sensor wandert (Nullpunktdrift)</translation>
    </message>
    <message>
        <source>Force readings late (delay)</source>
        <translation>Messwerte verspätet (Verzögerung)</translation>
    </message>
    <message>
        <source>Force readings smoothed (low-pass filter)</source>
        <translation>Messwerte geglättet (Tiefpass)</translation>
    </message>
    <message>
        <source>Accelerations late (motion lag)</source>
        <translation>Beschleunigungen verspätet (Nachlauf der Bewegung)</translation>
    </message>
    <message>
        <source>Sensor rotated on its mount</source>
        <translation>Sensor verdreht montiert</translation>
    </message>
    <message>
        <source>One channel reads wrong (gain error)</source>
        <translation>Ein Kanal misst falsch (Verstärkungsfehler)</translation>
    </message>
    <message>
        <source>One channel leaks into another (crosstalk)</source>
        <translation>Ein Kanal wirkt auf einen anderen (Übersprechen)</translation>
    </message>
    <message>
        <source>Steady pull from outside (constant force)</source>
        <translation>Steter Zug von außen (konstante Kraft)</translation>
    </message>
    <message>
        <source>Resistance grows with speed (viscous drag)</source>
        <translation>Widerstand wächst mit dem Tempo (viskose Dämpfung)</translation>
    </message>
    <message>
        <source>Does the tool drag along hoses full of liquid, dampers, bellows or covers?</source>
        <translation>Zieht das Werkzeug gefüllte Schläuche, Dämpfer, Bälge oder Hüllen mit?</translation>
    </message>
    <message>
        <source>Something rubs (Coulomb friction)</source>
        <translation>Etwas reibt (Coulomb-Reibung)</translation>
    </message>
    <message>
        <source>Repeat one movement at several speeds, and reverse it after short and long distances.</source>
        <translation>Eine Bewegung mit mehreren Tempi wiederholen und nach kurzen und langen Wegen umkehren.</translation>
    </message>
    <message>
        <source>Something is loose in the tool</source>
        <translation>Etwas Loses im Werkzeug</translation>
    </message>
    <message>
        <source>Move and stop abruptly a few times in different directions: a loose part keeps swinging.</source>
        <translation>Einige Male in verschiedene Richtungen bewegen und abrupt anhalten: Was lose ist, schwingt nach.</translation>
    </message>
    <message>
        <source>A small, fast ringing after every jerk, always at the same frequency.</source>
        <translation>Ein feines, schnelles Nachklingen nach jedem Ruck, immer gleich hoch.</translation>
    </message>
    <message>
        <source>Load changed during the recording</source>
        <translation>Last änderte sich unterwegs</translation>
    </message>
    <message>
        <source>The tool touched something (contact)</source>
        <translation>Das Werkzeug berührte etwas (Kontakt)</translation>
    </message>
    <message>
        <source>Sensor at its limit (saturation)</source>
        <translation>Sensor am Anschlag (Sättigung)</translation>
    </message>
    <message>
        <source>Joint angle off (encoder offset)</source>
        <translation>Gelenkwinkel daneben (Geberversatz)</translation>
    </message>
    <message>
        <source>Spikes in the readings</source>
        <translation>Ausreißer</translation>
    </message>
    <message>
        <source>Sensor position wrong (lever arm)</source>
        <translation>Ort des Sensors stimmt nicht (Hebelarm)</translation>
    </message>
    <message>
        <source>Rotate the tool fast back and forth about all three axes.</source>
        <translation>Das Werkzeug schnell um alle drei Achsen hin und her drehen.</translation>
    </message>
    <message>
        <source>Accelerations wrong</source>
        <translation>Beschleunigungen daneben</translation>
    </message>
    <message>
        <source>Sensor remembers its load (hysteresis)</source>
        <translation>Sensor merkt sich seine Last (Hysterese)</translation>
    </message>
    <message>
        <source>Readings lost or repeated (dropouts)</source>
        <translation>Messwerte verloren oder wiederholt (Aussetzer)</translation>
    </message>
    <message>
        <source>Uneven time stamps (jitter)</source>
        <translation>Ungleichmäßige Zeitstempel (Jitter)</translation>
    </message>
    <message>
        <source>In fast motion the measured curve jitters back and forth in time.</source>
        <translation>Bei schneller Bewegung zittert die gemessene Kurve zeitlich vor und zurück.</translation>
    </message>
    <message>
        <source>Coarse readings (quantisation)</source>
        <translation>Grobe Messwerte (Quantisierung)</translation>
    </message>
    <message>
        <source>The sensor&apos;s zero drifts until it settles: {} by {} {}.</source>
        <translation>Die Null des Sensors kriecht: {} um {} {}, bis sie sich beruhigt.</translation>
    </message>
    <message>
        <source>{} % of the force readings repeat the previous one.</source>
        <translation>{} % der Kraftwerte wiederholen den davor.</translation>
    </message>
    <message>
        <source>The angle of joint {} is {} degrees off.</source>
        <translation>Gelenk {} steht in Wahrheit {} Grad neben dem aufgenommenen Winkel.</translation>
    </message>
    <message>
        <source>The sensor remembers {} of its load: it reads differently while it is loaded and unloaded.</source>
        <translation>Der Sensor merkt sich {} seiner Last: Er zeigt beim Belasten anderes als beim Entlasten.</translation>
    </message>
    <message>
        <source>The motion arrives {} ms after the force readings.</source>
        <translation>Die Kraftwerte kommen {} ms vor der Bewegung.</translation>
    </message>
    <message>
        <source>The accelerations lag by {} ms; the angles do not.</source>
        <translation>Beschleunigungen kommen {} ms zu spät; die Winkel nicht.</translation>
    </message>
    <message>
        <source>The sensor is rotated by {} degrees.</source>
        <translation>Der Sensor sitzt um {} Grad verdreht.</translation>
    </message>
    <message>
        <source>Something pulls on the tool with {} N, always in the same direction.</source>
        <translation>Etwas zieht mit {} N am Werkzeug, immer in dieselbe Richtung.</translation>
    </message>
    <message>
        <source>Something resists rotation: {} N m per radian per second.</source>
        <translation>Etwas bremst das Drehen: {} N m pro Radiant pro Sekunde.</translation>
    </message>
    <message>
        <source>Something resists the tool&apos;s motion: {} N per metre per second.</source>
        <translation>Etwas bremst das Werkzeug: {} N pro Meter pro Sekunde.</translation>
    </message>
    <message>
        <source>Something rubs and resists the tool&apos;s motion with {} N.</source>
        <translation>Etwas reibt und hält das Werkzeug mit {} N zurück.</translation>
    </message>
    <message>
        <source>Something rubs and resists rotation with {} N m.</source>
        <translation>Etwas reibt und bremst das Drehen mit {} N m.</translation>
    </message>
    <message>
        <source>About {} g of the tool is loose and swings {} times a second.</source>
        <translation>Etwa {} g im Werkzeug sind lose und schwingen {}-mal pro Sekunde.</translation>
    </message>
    <message>
        <source>The sensor&apos;s origin is {} mm from where the setup file puts it.</source>
        <translation>Der Ursprung des Sensors sitzt {} mm neben der Stelle aus der Aufbaudatei.</translation>
    </message>
    <message>
        <source>The inertial forces differ by {} % from what the motion predicts.</source>
        <translation>Die Beschleunigungskräfte liegen {} % neben dem, was die Bewegung sagt.</translation>
    </message>
    <message>
        <source>About {} g of the tool is loose and rolls to another place as the tool turns.</source>
        <translation>Etwa {} g im Werkzeug sind lose und rollen an eine andere Stelle, wenn es sich dreht.</translation>
    </message>
    <message>
        <source>Near the end of its range the channel {} reads {} % too little.</source>
        <translation>Nahe dem Ende seines Messbereichs zeigt der Kanal {} {} % weniger, als da ist.</translation>
    </message>
    <message>
        <source>The payload is given in the sensor frame that the setup file states.</source>
        <translation>Die Nutzlast gilt für Ort und Achsen des Sensors, wie die Aufbaudatei sie angibt.</translation>
    </message>
    <message>
        <source>If you use the corrected setup file, estimate again with it.</source>
        <translation>Wird die korrigierte Aufbaudatei verwendet, mit ihr noch einmal schätzen.</translation>
    </message>
    <message>
        <source>The channel {} is {:+.1f} % off in one direction and {:+.1f} % in the other.</source>
        <translation>Der Kanal {} liegt zur einen Seite um {:+.1f} % daneben und zur anderen um {:+.1f} %.</translation>
    </message>
    <message>
        <source>Check what switches, vibrates or rotates on the tool at these times.</source>
        <translation>Sehen Sie nach, was am Werkzeug in diesen Augenblicken schaltet, rüttelt oder dreht.</translation>
    </message>
    <message>
        <source>All forces read {} % too much compared with the torques.</source>
        <translation>Alle Kräfte werden gegenüber den Momenten {} % zu groß gemessen.</translation>
    </message>
    <message>
        <source>All forces read {} % too little compared with the torques.</source>
        <translation>Alle Kräfte werden gegenüber den Momenten {} % zu klein gemessen.</translation>
    </message>
    <message>
        <source>The clocks of the force readings and of the motion drift apart by {} ms per second.</source>
        <translation>Die Uhren von Kraftwerten und Bewegung laufen auseinander, um {} ms je Sekunde.</translation>
    </message>
    <message>
        <source>The sensor remembers its load: loading and unloading differ by {} % of the load&apos;s range.</source>
        <translation>Der Sensor merkt sich seine Last: Auf dem Weg hinauf zeigt er um {} % des Lastbereichs anders an als auf dem Weg hinab.</translation>
    </message>
    <message>
        <source>From {} s on, something pulls on the tool with {} N, always in the same direction.</source>
        <translation>Ab {} s zieht etwas mit {} N am Werkzeug, immer in dieselbe Richtung.</translation>
    </message>
    <message>
        <source>Something resists the tool&apos;s motion by up to {} N per metre per second.</source>
        <translation>Etwas bremst das Werkzeug, mit bis zu {} N pro Meter pro Sekunde.</translation>
    </message>
    <message>
        <source>Something rubs and resists the tool&apos;s motion with up to {} N.</source>
        <translation>Etwas reibt und hält das Werkzeug mit bis zu {} N zurück.</translation>
    </message>
    <message>
        <source>The angle of joint {} is off by up to {} degrees, varying once per turn.</source>
        <translation>Gelenk {} wird bis zu {} Grad falsch gelesen, einmal je Umdrehung hin und her.</translation>
    </message>
    <message>
        <source>From {} s on, the sensor&apos;s zero drifts until it settles: {} by {} {}.</source>
        <translation>Ab {} s kriecht die Null des Sensors: {} um {} {}, bis sie sich beruhigt.</translation>
    </message>
    <message>
        <source>The sensor&apos;s zero drifts back and forth: {} by {} {} in total.</source>
        <translation>Die Null des Sensors wandert hin und her: {} um insgesamt {} {}.</translation>
    </message>
    <message>
        <source>Something resists the tool&apos;s motion with the square of its speed: {} N at one metre per second.</source>
        <translation>Etwas bremst das Werkzeug mit dem Quadrat seiner Geschwindigkeit: {} N bei einem Meter pro Sekunde.</translation>
    </message>
    <message>
        <source>A torque grows as the tool rotates and drives it further: {} N m per radian.</source>
        <translation>Etwas verdreht das Werkzeug umso mehr, je weiter es sich dreht: {} N m je Radiant.</translation>
    </message>
    <message>
        <source>Something, such as a hand on the tool, pushes it in its direction of motion: {} N per metre per second.</source>
        <translation>Etwas, etwa eine Hand am Werkzeug, schiebt in Richtung der Bewegung: {} N je Meter pro Sekunde.</translation>
    </message>
    <message>
        <source>Something, such as a hand on the tool, drives its rotation: {} N m per radian per second.</source>
        <translation>Etwas, etwa eine Hand am Werkzeug, dreht es weiter: {} N m je Radiant pro Sekunde.</translation>
    </message>
    <message>
        <source>Something, such as a hand on the tool, pushes it in its direction of motion with {} N.</source>
        <translation>Etwas, etwa eine Hand am Werkzeug, schiebt mit {} N in Richtung der Bewegung.</translation>
    </message>
    <message>
        <source>Something, such as a hand on the tool, drives its rotation with {} N m.</source>
        <translation>Etwas, etwa eine Hand am Werkzeug, dreht es mit {} N m weiter.</translation>
    </message>
    <message>
        <source>{} % of the readings were delivered a second time in place of new ones.</source>
        <translation>{} % der Anzeigen wurden ein zweites Mal ausgegeben, statt neuer.</translation>
    </message>
    <message>
        <source>{} uses only every other step of {:.2g} {}: one bit of its converter appears to be stuck.</source>
        <translation>{} lässt jede zweite Stufe von {:.2g} {} aus: Ein Bit des Wandlers ändert sich nie.</translation>
    </message>
    <message>
        <source>Restart the sensor&apos;s electronics; if that does not help, have them repaired.</source>
        <translation>Starten Sie die Elektronik des Sensors neu; hilft das nicht, lassen Sie sie reparieren.</translation>
    </message>
    <message>
        <source>At {:.2f} s the readings jump briefly to implausible values.</source>
        <translation>Bei {:.2f} s springen die Messwerte dorthin, wohin keine Last sie bringt, und zurück.</translation>
    </message>
    <message>
        <source>{} % of the recorded positions repeat the previous one although the tool was moving.</source>
        <translation>{} % der aufgezeichneten Positionen wiederholen die vorige, während das Werkzeug sich weiterbewegte.</translation>
    </message>
    <message>
        <source>Makes {} worse: {}. That recording does not have this fault, or has it differently.</source>
        <translation>Macht {} schlechter: {}. Dort liegt es nicht vor, oder anders.</translation>
    </message>
    <message>
        <source>Makes no difference on {}: {}. Its motion does not excite this fault.</source>
        <translation>Macht bei {} keinen Unterschied: {}. Die Bewegung dort zeigt es nicht.</translation>
    </message>
    <message>
        <source>One reading jumps for a single row. It was replaced by interpolation.</source>
        <translation>Ein Messwert springt eine einzige Zeile lang. Er wurde durch das ersetzt, was daneben liegt.</translation>
    </message>
    <message>
        <source>{} readings jump for a single row, too few to determine why. They were replaced by interpolation.</source>
        <translation>{} Messwerte springen je eine einzige Zeile lang; zu wenige, um zu sagen, woher das kommt. Sie wurden durch das ersetzt, was daneben liegt.</translation>
    </message>
    <message>
        <source>There is less evidence for {} than for the unexplained part, and it may belong to that. It is not reported as a cause.</source>
        <translation>Für {} spricht weniger als für das, was hier unerklärt bleibt, und es mag ein Teil davon sein. Es wird nicht als Ursache genannt.</translation>
    </message>
    <message>
        <source>The readings look as if the sensor were turned by about {:.1f} degrees from where the setup file has it. The centre of mass is off accordingly, by more than its interval says.</source>
        <translation>Die Messwerte sehen aus, als wäre der Sensor um etwa {:.1f} Grad gegen die Angabe in der Aufbaudatei verdreht. Entsprechend weicht der Schwerpunkt ab, um mehr, als sein Intervall sagt.</translation>
    </message>
    <message>
        <source>Force and torque do not agree: in the torque, mass times lever is about {:.0f} % of what it is in the force. Mass and centre may be off by as much.</source>
        <translation>Kraft und Drehmoment passen nicht zusammen: Im Drehmoment beträgt Masse mal Hebel etwa {:.0f} % dessen, was die Kraft sagt. Masse und Schwerpunkt können um ebenso viel abweichen.</translation>
    </message>
    <message>
        <source>its columns could not be read again.</source>
        <translation>ihre Spalten konnten nicht noch einmal gelesen werden.</translation>
    </message>
    <message>
        <source>The forces fit an accelerometer at {:.0f}, {:.0f}, {:.0f} mm from the sensor&apos;s origin.</source>
        <translation>Die Kräfte passen zu einem Beschleunigungssensor bei {:.0f}, {:.0f}, {:.0f} mm vom Ursprung des Sensors.</translation>
    </message>
    <message>
        <source>{}, which this machine cannot unpack (pip: hdf5plugin, with HDF5_PLUGIN_PATH at its plugins)</source>
        <translation>{}, was dieser Rechner nicht entpacken kann (pip: hdf5plugin, mit HDF5_PLUGIN_PATH auf dessen plugins)</translation>
    </message>
    <message>
        <source>the files&apos; clocks have nothing in common</source>
        <translation>die Uhren der Dateien haben nichts gemeinsam</translation>
    </message>
    <message>
        <source>accelerometer</source>
        <translation>Beschleunigungssensor</translation>
    </message>
    <message>
        <source>gyroscope</source>
        <translation>Drehratensensor</translation>
    </message>
    <message>
        <source>Known are time, q1 to q7, dq1 to dq7, px, py, pz, qx, qy, qz, qw, fx, fy, fz, tx, ty, tz, ax, ay, az, and the groups joints, velocities, position, quaternion, rotation, wrench, accelerometer, gyroscope, and demo.</source>
        <translation>Bekannt sind time, q1 bis q7, dq1 bis dq7, px, py, pz, qx, qy, qz, qw, fx, fy, fz, tx, ty, tz, ax, ay, az und die Gruppen joints, velocities, position, quaternion, rotation, wrench, accelerometer, gyroscope sowie demo.</translation>
    </message>
    <message>
        <source>it was there for {} of {} samples only</source>
        <translation>er war nur bei {} von {} Werten da</translation>
    </message>
    <message>
        <source>The accelerometer was not used: its readings do not follow how gravity turns in the sensor.</source>
        <translation>Der Beschleunigungssensor wurde nicht verwendet: seine Werte folgen nicht der Drehung der Schwerkraft im Sensor.</translation>
    </message>
    <message>
        <source>The sensor&apos;s acceleration was taken from the accelerometer, which is turned by {} degrees (roll, pitch, yaw) against the sensor, as the data show.</source>
        <translation>Die Beschleunigung des Sensors stammt vom Beschleunigungssensor, der den Daten nach um {} Grad (Roll, Nick, Gier) gegen den Sensor verdreht ist.</translation>
    </message>
    <message>
        <source>The accelerometer agrees with the motion to {:.2g} m/s2 rms; it is turned by {} degrees (roll, pitch, yaw) against the sensor and stands at {:.0f}, {:.0f}, {:.0f} mm.</source>
        <translation>Der Beschleunigungssensor stimmt auf {:.2g} m/s2 eff. mit der Bewegung überein; er ist um {} Grad (Roll, Nick, Gier) gegen den Sensor verdreht und sitzt bei {:.0f}, {:.0f}, {:.0f} mm.</translation>
    </message>
    <message>
        <source>The accelerometer&apos;s readings are</source>
        <translation>Die Werte des Beschleunigungssensors fehlen</translation>
    </message>
    <message>
        <source>The gyroscope&apos;s readings are</source>
        <translation>Die Werte des Drehratensensors fehlen</translation>
    </message>
    <message>
        <source>The accelerometer reads {:.3g} most of the time, so it is in g.</source>
        <translation>Der Beschleunigungssensor zeigt meist {:.3g}, er misst also in g.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>{:.1f} % of the remaining difference is related to {}; no cause in the catalogue accounts for it.</source>
        <translation>{:.1f} % des verbleibenden Unterschieds hängen mit {} zusammen; keine Ursache im Katalog erklärt das.</translation>
    </message>
    <message>
        <source>The remaining difference is related to {}; no cause in the catalogue accounts for it.</source>
        <translation>Der verbleibende Unterschied hängt mit {} zusammen; keine Ursache im Katalog erklärt das.</translation>
    </message>
    <message>
        <source>A segment of {:.1f} s was excluded: what acts there is related to {} and is not contact.</source>
        <translation>Ein Abschnitt von {:.1f} s blieb außen vor: Was dort wirkt, hängt mit {} zusammen und ist keine Berührung.</translation>
    </message>
    <message>
        <source>{} segments, {:.1f} s in total, were excluded: what acts there is related to {} and is not contact.</source>
        <translation>{} Abschnitte, zusammen {:.1f} s, blieben außen vor: Was dort wirkt, hängt mit {} zusammen und ist keine Berührung.</translation>
    </message>
    <message>
        <source>Two or more causes are possible: &quot;{}&quot; or {}. This motion cannot distinguish them.</source>
        <translation>Zwei oder mehr Ursachen sind möglich: „{}“ oder {}. Diese Bewegung kann sie nicht unterscheiden.</translation>
    </message>
    <message>
        <source>Something unknown remains; it is related to {}.</source>
        <translation>Es bleibt etwas Unbekanntes; es hängt mit {} zusammen.</translation>
    </message>
    <message>
        <source>The recording has no position of the sensor, so the acceleration of its origin is unknown: that is the first suspect.</source>
        <translation>Die Aufnahme enthält keinen Ort des Sensors; die Beschleunigung seines Ursprungs ist deshalb unbekannt: Das ist der erste Verdacht.</translation>
    </message>
    <message>
        <source>Cause found: {}</source>
        <translation>Ursache gefunden: {}</translation>
    </message>
    <message>
        <source>{} causes found; the strongest: {}</source>
        <translation>{} Ursachen gefunden; die stärkste: {}</translation>
    </message>
    <message>
        <source>The entered mass of {:.3f} kg is off by {:+.3f} kg; noise and intervals allow {:.3f} kg.</source>
        <translation>Die eingetragene Masse von {:.3f} kg liegt um {:+.3f} kg daneben; Rauschen und Intervalle lassen {:.3f} kg zu.</translation>
    </message>
    <message>
        <source>Check which tool is mounted and that the number was entered in kg, or estimate it again.</source>
        <translation>Prüfen Sie, welches Werkzeug montiert ist und ob die Zahl in kg eingetragen wurde, oder schätzen Sie neu.</translation>
    </message>
    <message>
        <source>The entered centre of mass is off by {:+.1f}, {:+.1f}, {:+.1f} mm along x, y, z; noise and intervals allow {:.1f} mm.</source>
        <translation>Der eingetragene Schwerpunkt liegt um {:+.1f}, {:+.1f}, {:+.1f} mm in x, y, z daneben; Rauschen und Intervalle lassen {:.1f} mm zu.</translation>
    </message>
    <message>
        <source>Check that the numbers are in sensor axes and metres, or estimate it again.</source>
        <translation>Prüfen Sie, ob die Zahlen in Sensorachsen und Metern stehen, oder schätzen Sie neu.</translation>
    </message>
    <message>
        <source>Check its unit and that it is about the centre of mass, or estimate it again.</source>
        <translation>Prüfen Sie die Einheit und ob sie sich auf den Schwerpunkt bezieht, oder schätzen Sie neu.</translation>
    </message>
    <message>
        <source>{}: the mass must be above zero.</source>
        <translation>{}: Die Masse muss größer als null sein.</translation>
    </message>
    <message>
        <source>A proof compares with what the motion alone shows: method map, all parameters, no shape.</source>
        <translation>Ein Nachweis vergleicht mit dem, was die Bewegung allein sagt: Verfahren map, alle Parameter, keine Form.</translation>
    </message>
    <message>
        <source>Estimate the payload again, and look at its findings.</source>
        <translation>Schätzen Sie die Last neu und sehen Sie die Hinweise an.</translation>
    </message>
    <message>
        <source>NOT YET.</source>
        <translation>NOCH NICHT.</translation>
    </message>
    <message>
        <source>The sensor is mounted on {} in {} and on {} in {}.</source>
        <translation>Der Sensor ist an {} montiert in {} und an {} in {}.</translation>
    </message>
    <message>
        <source>The sensor is turned by {:.2f} degrees between {} and {}.</source>
        <translation>Der Sensor ist um {:.2f} Grad verdreht zwischen {} und {}.</translation>
    </message>
    <message>
        <source>The two recordings name different sensors: &quot;{}&quot; and &quot;{}&quot;.</source>
        <translation>Die beiden Aufnahmen nennen verschiedene Sensoren: „{}“ und „{}“.</translation>
    </message>
    <message>
        <source>Use recordings of the same sensor: another one has other axes and another gain.</source>
        <translation>Verwenden Sie Aufnahmen desselben Sensors: Ein anderer hat andere Achsen und eine andere Verstärkung.</translation>
    </message>
    <message>
        <source>The two recordings state different gravity: {:.3f} and {:.3f} m/s2.</source>
        <translation>Die beiden Aufnahmen geben verschiedene Schwerkraft an: {:.3f} und {:.3f} m/s2.</translation>
    </message>
    <message>
        <source>State the same &quot;gravity_m_s2&quot; in both setup files.</source>
        <translation>Geben Sie in beiden Aufbaudateien dasselbe „gravity_m_s2“ an.</translation>
    </message>
    <message>
        <source>The object is found by the method map with all parameters and without a shape or a stated mass, which would be that of one of the two bodies.</source>
        <translation>Der Gegenstand wird mit dem Verfahren map, allen Parametern und ohne Form oder bekannte Masse bestimmt; diese gälte nur für einen der beiden Körper.</translation>
    </message>
    <message>
        <source>The object is the difference of two estimates in the same sensor axes: state the same &quot;mount&quot; in both setup files, or record both with the same one.</source>
        <translation>Der Gegenstand ist die Differenz zweier Schätzungen in denselben Sensorachsen: Geben Sie in beiden Aufbaudateien dasselbe „mount“ an, oder nehmen Sie beide mit derselben Montage auf.</translation>
    </message>
    <message>
        <source>The tool is {:.3f} kg lighter with the object than without it.</source>
        <translation>Das Werkzeug ist mit dem Gegenstand {:.3f} kg leichter als ohne ihn.</translation>
    </message>
    <message>
        <source>The object cannot be weighed. {}</source>
        <translation>Der Gegenstand lässt sich nicht wiegen. {}</translation>
    </message>
    <message>
        <source>The object weighs {:.3f} kg.</source>
        <translation>Der Gegenstand wiegt {:.3f} kg.</translation>
    </message>
    <message>
        <source>Its mass, centre of mass and inertia are measured.</source>
        <translation>Masse, Schwerpunkt und Trägheit sind gemessen.</translation>
    </message>
    <message>
        <source>Check the warnings below first: the errors may be larger than the intervals.</source>
        <translation>Prüfen Sie zuerst die Warnungen unten: Die Zahlen können um mehr danebenliegen, als sie sagen.</translation>
    </message>
    <message>
        <source>The entered inertia does not match the torques during rotation.</source>
        <translation>Die eingetragene Trägheit passt nicht zu den Drehmomenten beim Drehen.</translation>
    </message>
    <message>
        <source>An error of {:.3f} kg or {:.1f} mm would go unnoticed in this recording.</source>
        <translation>Ein Fehler von {:.3f} kg oder {:.1f} mm bliebe in dieser Aufnahme unbemerkt.</translation>
    </message>
    <message>
        <source>The payload&apos;s own interval is too wide: estimate it from a better motion first.</source>
        <translation>Das Intervall der Last selbst ist zu breit: Schätzen Sie sie zuerst aus einer besseren Bewegung.</translation>
    </message>
    <message>
        <source>{} marks its own numbers as not trustworthy.</source>
        <translation>{} kennzeichnet die eigenen Zahlen als nicht vertrauenswürdig.</translation>
    </message>
    <message>
        <source>Find the cause first, for instance with a diagnosis.</source>
        <translation>Finden Sie zuerst die Ursache, etwa mit einer Diagnose.</translation>
    </message>
    <message>
        <source>NOT YET. This recording is not sufficient.</source>
        <translation>NOCH NICHT. Diese Aufnahme reicht nicht aus.</translation>
    </message>
    <message>
        <source>No object detected: the two recordings differ by {:.4f} +- {:.2g} kg.</source>
        <translation>Kein Gegenstand erkannt: Die beiden Aufnahmen unterscheiden sich um {:.4f} +- {:.2g} kg.</translation>
    </message>
    <message>
        <source>Its mass and centre are measured; these motions do not determine its inertia.</source>
        <translation>Masse und Schwerpunkt sind gemessen; die Trägheit bestimmen diese Bewegungen nicht.</translation>
    </message>
    <message>
        <source>Its centre of mass is not fully determined by these motions.</source>
        <translation>Der Schwerpunkt ist durch diese Bewegungen nicht ganz bestimmt.</translation>
    </message>
    <message>
        <source>{} found no cause, so {} cannot be left out.</source>
        <translation>{} fand keine Ursache, also kann {} nicht weggelassen werden.</translation>
    </message>
    <message>
        <source>{} did not find the cause {}; it found {}.</source>
        <translation>{} fand die Ursache {} nicht; gefunden wurde {}.</translation>
    </message>
    <message>
        <source>It happened at {:.1f} s, after the end of this motion.</source>
        <translation>Es geschah bei {:.1f} s, nach dem Ende dieser Bewegung.</translation>
    </message>
    <message>
        <source>It is switched off.</source>
        <translation>Sie ist abgeschaltet.</translation>
    </message>
    <message>
        <source>It has no model that could be carried to another motion.</source>
        <translation>Sie hat kein Modell, das sich auf eine andere Bewegung übertragen ließe.</translation>
    </message>
    <message>
        <source>{}: its payload cannot exist: {}</source>
        <translation>{}: Diese Last kann es nicht geben: {}</translation>
    </message>
    <message>
        <source>Neither mass nor centre of mass can be checked with this recording.</source>
        <translation>Weder Masse noch Schwerpunkt lassen sich mit dieser Aufnahme prüfen.</translation>
    </message>
    <message>
        <source>others by less</source>
        <translation>andere um weniger</translation>
    </message>
    <message>
        <source>{} does not state where the sensor is mounted; make it again with heft diagnose REC --json FILE.</source>
        <translation>{} sagt nicht, wo der Sensor sitzt; erzeugen Sie die Datei neu mit heft diagnose REC --json FILE.</translation>
    </message>
    <message>
        <source>Comparing ways to smooth the motion</source>
        <translation>Glättungen der Bewegung werden verglichen</translation>
    </message>
    <message>
        <source>the tool</source>
        <translation>das Werkzeug</translation>
    </message>
    <message>
        <source>part {} of the tool</source>
        <translation>Teil {} des Werkzeugs</translation>
    </message>
    <message>
        <source>{} and {} come within {:.0f} mm of each other, {:.1f} s into the motion.</source>
        <translation>{} und {} kommen einander auf {:.0f} mm nahe, {:.1f} s nach Beginn der Bewegung.</translation>
    </message>
    <message>
        <source>{} and {} collide {:.1f} s into the motion.</source>
        <translation>{} und {} stoßen {:.1f} s nach Beginn der Bewegung zusammen.</translation>
    </message>
    <message>
        <source>{} and {}</source>
        <translation>{} und {}</translation>
    </message>
    <message>
        <source>The hull of {} points cannot be computed.</source>
        <translation>Die Hülle von {} Punkten lässt sich nicht bestimmen.</translation>
    </message>
    <message>
        <source>{}: {} must be three numbers between -{:.0f} and {:.0f}.</source>
        <translation>{}: {} muss aus drei Zahlen zwischen -{:.0f} und {:.0f} bestehen.</translation>
    </message>
    <message>
        <source>{}: a mesh needs &quot;file&quot;.</source>
        <translation>{}: Ein Netz braucht &quot;file&quot;.</translation>
    </message>
    <message>
        <source>{}: the unit of a mesh is m, cm, mm or in.</source>
        <translation>{}: Die Einheit eines Netzes ist m, cm, mm oder in.</translation>
    </message>
    <message>
        <source>{}: {} holds no triangle.</source>
        <translation>{}: {} enthält kein Dreieck.</translation>
    </message>
    <message>
        <source>{} needs a &quot;name&quot;, by which it is called in messages.</source>
        <translation>{} braucht einen &quot;name&quot;, unter dem es in Meldungen steht.</translation>
    </message>
    <message>
        <source>{} ({}) must be one of &quot;plane&quot;, &quot;box&quot; and &quot;mesh&quot;.</source>
        <translation>{} ({}) muss eines von &quot;plane&quot;, &quot;box&quot; und &quot;mesh&quot; sein.</translation>
    </message>
    <message>
        <source>{}: margin_m must be a number from 0 to 0.5.</source>
        <translation>{}: margin_m muss eine Zahl von 0 bis 0.5 sein.</translation>
    </message>
    <message>
        <source>{}, obstacle {}</source>
        <translation>{}, Hindernis {}</translation>
    </message>
    <message>
        <source>{}: two obstacles are called {}.</source>
        <translation>{}: Zwei Hindernisse heißen {}.</translation>
    </message>
    <message>
        <source>it moves by {:.0f} mm while it is pressed</source>
        <translation>es bewegt sich um {:.0f} mm, während es drückt</translation>
    </message>
    <message>
        <source>Where the tool was is not known: joint angles, or poses with positions, are needed.</source>
        <translation>Wo das Werkzeug war, ist nicht bekannt: Gelenkwinkel oder Posen mit Positionen werden gebraucht.</translation>
    </message>
    <message>
        <source>Press the tool against the wall or table and hold it for a second.</source>
        <translation>Drücken Sie das Werkzeug gegen die Wand oder den Tisch und halten Sie es eine Sekunde lang.</translation>
    </message>
    <message>
        <source>{}: the payload changes in the same direction at {:.1f} and {:.1f} s, so there are three of them. Give two recordings, one with the object and one without.</source>
        <translation>{}: Die Last ändert sich bei {:.1f} und {:.1f} s in dieselbe Richtung, es sind also drei. Geben Sie zwei Aufnahmen an, eine mit dem Gegenstand und eine ohne.</translation>
    </message>
    <message>
        <source>Adds next to nothing: without it the intervals are as narrow.</source>
        <translation>Bringt so gut wie nichts: Ohne sie sind die Bereiche ebenso schmal.</translation>
    </message>
    <message>
        <source>Without it the intervals of mass, centre and inertia are {:.1f}, {:.1f} and {:.1f} times as wide.</source>
        <translation>Ohne sie sind die Bereiche von Masse, Schwerpunkt und Trägheit {:.1f}-, {:.1f}- und {:.1f}-mal so breit.</translation>
    </message>
    <message>
        <source>The only one that is used.</source>
        <translation>Die einzige, die verwendet wird.</translation>
    </message>
    <message>
        <source>The rows are of {} frames, each a source of its own: {}.</source>
        <translation>Die Zeilen gehören zu {} Koordinatensystemen, jedes eine eigene Quelle: {}.</translation>
    </message>
    <message>
        <source>To judge delays, record force and motion on one clock.</source>
        <translation>Um Verzögerungen zu beurteilen, zeichnen Sie Kraft und Bewegung mit einer Uhr auf.</translation>
    </message>
    <message>
        <source>an inertial sensor&apos;s own estimate, which knows nothing of the robot&apos;s base</source>
        <translation>eine Schätzung des Inertialsensors selbst, der von der Basis des Roboters nichts weiß</translation>
    </message>
    <message>
        <source>pose of a FANUC: mm, and W, P, R in degrees</source>
        <translation>Pose eines FANUC: mm, und W, P, R in Grad</translation>
    </message>
    <message>
        <source>{}: several frames move on this topic ({}); {} is taken for the sensor.</source>
        <translation>{}: Auf diesem Topic bewegen sich mehrere Koordinatensysteme ({}); {} wird für den Sensor genommen.</translation>
    </message>
    <message>
        <source>a matrix of 4 x 4, row by row</source>
        <translation>eine Matrix von 4 x 4, Zeile für Zeile</translation>
    </message>
    <message>
        <source>What the controller is set to needs a mass of zero or more.</source>
        <translation>Was in der Steuerung steht, braucht eine Masse von null oder mehr.</translation>
    </message>
    <message>
        <source>A passport needs the tool&apos;s name.</source>
        <translation>Ein Pass braucht den Namen des Werkzeugs.</translation>
    </message>
    <message>
        <source>Nothing in this result can be trusted, so no passport is made of it.</source>
        <translation>Nichts an diesem Ergebnis ist verlässlich, daher wird kein Pass daraus.</translation>
    </message>
    <message>
        <source>the new passport</source>
        <translation>der neue Pass</translation>
    </message>
    <message>
        <source>{} is the passport of another tool, &quot;{}&quot;.</source>
        <translation>{} ist der Pass eines anderen Werkzeugs, „{}“.</translation>
    </message>
    <message>
        <source>{} holds no payload. Heft reads a Franka Desk end effector, a Franka tool profile, a result of &apos;heft estimate&apos; and a payload with mass_kg, com_m and inertia_com_kgm2.</source>
        <translation>{} enthält keine Last. Heft liest einen Endeffektor aus Franka Desk, ein Werkzeugprofil von Franka, ein Ergebnis von &apos;heft estimate&apos; und eine Last mit mass_kg, com_m und inertia_com_kgm2.</translation>
    </message>
    <message>
        <source>should be a number above zero</source>
        <translation>sollte eine Zahl über null sein</translation>
    </message>
    <message>
        <source>What a fault would do is shown along a motion, not in standing poses.</source>
        <translation>Was ein Fehler täte, zeigt sich in einer Bewegung, nicht in Haltungen.</translation>
    </message>
    <message>
        <source>Too little free motion is left to show what a fault would do.</source>
        <translation>Es bleibt zu wenig freie Bewegung, um zu zeigen, was ein Fehler täte.</translation>
    </message>
    <message>
        <source>{}: &quot;{}&quot; {}.</source>
        <translation>{}: „{}“ {}.</translation>
    </message>
    <message>
        <source>should be a text, or one for each language with &quot;en&quot; among them</source>
        <translation>sollte ein Text sein, oder einer je Sprache, darunter „en“</translation>
    </message>
    <message>
        <source>should be a number above 0, up to {}</source>
        <translation>sollte eine Zahl über 0 und bis {} sein</translation>
    </message>
    <message>
        <source>should be an object with &quot;say&quot;</source>
        <translation>sollte ein Objekt mit „say“ sein</translation>
    </message>
    <message>
        <source>should hold causes and their sizes</source>
        <translation>sollte Ursachen und ihre Größen enthalten</translation>
    </message>
    <message>
        <source>should be a number from 0</source>
        <translation>sollte eine Zahl ab 0 sein</translation>
    </message>
    <message>
        <source>should be a list of causes</source>
        <translation>sollte eine Liste von Ursachen sein</translation>
    </message>
    <message>
        <source>should be an object with &quot;say&quot; and &quot;because&quot;</source>
        <translation>sollte ein Objekt mit „say“ und „because“ sein</translation>
    </message>
    <message>
        <source>should be an object with motion, seed ...</source>
        <translation>sollte ein Objekt mit motion, seed ... sein</translation>
    </message>
    <message>
        <source>should be a motion of &apos;heft simulate&apos;: free, excitation ...</source>
        <translation>sollte eine Bewegung von &apos;heft simulate&apos; sein: free, excitation ...</translation>
    </message>
    <message>
        <source>cannot exist: {}</source>
        <translation>kann es nicht geben: {}</translation>
    </message>
    <message>
        <source>should be a list of 1 to {} steps</source>
        <translation>sollte eine Liste von 1 bis {} Schritten sein</translation>
    </message>
    <message>
        <source>should be a list of 2 to {} answers</source>
        <translation>sollte eine Liste von 2 bis {} Antworten sein</translation>
    </message>
    <message>
        <source>should have one that is &quot;right&quot;: true</source>
        <translation>sollte genau eine mit „right“: true enthalten</translation>
    </message>
    <message>
        <source>Ask the controller&apos;s manual for the point, and state it as wrench_point in the setup file.</source>
        <translation>Suchen Sie den Punkt im Handbuch der Steuerung und geben Sie ihn als wrench_point in der Aufbaudatei an.</translation>
    </message>
    <message>
        <source>State wrench_point in the setup file, or record a motion with brisk turns.</source>
        <translation>Geben Sie wrench_point in der Aufbaudatei an oder nehmen Sie eine Bewegung mit flotten Drehungen auf.</translation>
    </message>
    <message>
        <source>The transform of {} alone was taken for the sensor&apos;s pose in the robot&apos;s base; transforms are not chained.</source>
        <translation>Die Transformation von {} allein wurde als Stellung des Sensors in der Roboterbasis genommen; Transformationen werden nicht verkettet.</translation>
    </message>
    <message>
        <source>If it begins elsewhere, record the joints, or the whole pose as one transform.</source>
        <translation>Beginnt sie anderswo, zeichnen Sie die Gelenke auf oder die ganze Stellung als eine Transformation.</translation>
    </message>
    <message>
        <source>For standing poses write &quot;kind&quot;: &quot;poses&quot; into the setup file.</source>
        <translation>Für stehende Posen sagen Sie &quot;kind&quot;: &quot;poses&quot; in der Aufbaudatei.</translation>
    </message>
    <message>
        <source>The sensor&apos;s mounting is not stated; it is assumed to be at the origin of the robot&apos;s link &quot;{}&quot;.</source>
        <translation>Nirgends steht, wo der Sensor sitzt; angenommen wird der Ursprung des Robotergliedes „{}“.</translation>
    </message>
    <message>
        <source>The arm is not strong enough for a motion from this posture: {}</source>
        <translation>Der Arm ist für eine Bewegung aus dieser Haltung nicht stark genug: {}</translation>
    </message>
    <message>
        <source>The arm cannot hold this load all along the taught path: {}</source>
        <translation>Der Arm kann diese Last nicht auf dem ganzen gelehrten Weg halten: {}</translation>
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
        <source>Centre {}</source>
        <translation>Schwerpunkt {}</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Numbers, in the sensor’s axes</source>
        <translation>Zahlen, in den Achsen des Sensors</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Beweis</translation>
    </message>
    <message>
        <source>These numbers were not proved on another recording.</source>
        <translation>Diese Zahlen wurden an keiner anderen Aufnahme bewiesen.</translation>
    </message>
    <message>
        <source>Causes of misfit</source>
        <translation>Ursachen von Abweichungen</translation>
    </message>
    <message>
        <source>The reality check was not run.</source>
        <translation>Die Realitätsprüfung wurde nicht durchgeführt.</translation>
    </message>
    <message>
        <source>Since the passport of {}</source>
        <translation>Seit dem Pass vom {}</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>geändert</translation>
    </message>
    <message>
        <source>{}, {}. Recording {}.</source>
        <translation>{}, {}. Aufnahme {}.</translation>
    </message>
    <message>
        <source>Payload passport: {}</source>
        <translation>Werkzeugpass: {}</translation>
    </message>
    <message>
        <source>Checked on {}.</source>
        <translation>Geprüft an {}.</translation>
    </message>
    <message>
        <source>NOT YET</source>
        <translation>NOCH NICHT</translation>
    </message>
    <message>
        <source>NOT YET: this recording is not sufficient.</source>
        <translation>NOCH NICHT: Diese Aufnahme reicht nicht aus.</translation>
    </message>
    <message>
        <source>load changes under {}</source>
        <translation>Laständerungen unter {}</translation>
    </message>
    <message>
        <source>cables softer than {}</source>
        <translation>Kabel weicher als {}</translation>
    </message>
    <message>
        <source>delays under {}</source>
        <translation>Verspätungen unter {}</translation>
    </message>
    <message>
        <source>tilts under {}</source>
        <translation>Neigungen unter {}</translation>
    </message>
    <message>
        <source>drifts under {}</source>
        <translation>Drift unter {}</translation>
    </message>
    <message>
        <source>loose parts under {}</source>
        <translation>lose Teile unter {}</translation>
    </message>
    <message>
        <source>a sensor turned by less than {}</source>
        <translation>ein Sensor, der weniger als {} verdreht ist</translation>
    </message>
    <message>
        <source>smoothing under {}</source>
        <translation>Glättung unter {}</translation>
    </message>
    <message>
        <source>wrong gains under {}</source>
        <translation>falsche Verstärkungen unter {}</translation>
    </message>
    <message>
        <source>joint angles off by less than {}</source>
        <translation>Gelenkwinkel weniger als {} daneben</translation>
    </message>
    <message>
        <source>steady pulls under {}</source>
        <translation>steter Zug unter {}</translation>
    </message>
    <message>
        <source>a sensor misplaced by less than {}</source>
        <translation>ein Sensor weniger als {} am falschen Ort</translation>
    </message>
    <message>
        <source>Picked up at {} s.</source>
        <translation>Aufgenommen bei {} s.</translation>
    </message>
    <message>
        <source>Put down at {} s.</source>
        <translation>Abgelegt bei {} s.</translation>
    </message>
    <message>
        <source>No name says which column holds the time; {} rises in even steps and was taken.</source>
        <translation>Kein Name sagt, welche Spalte die Zeit enthält; {} steigt in gleichmäßigen Schritten und wurde genommen.</translation>
    </message>
    <message>
        <source>The recording is read from {:.3f} to {:.3f} s, where the accelerometer was there.</source>
        <translation>Die Aufnahme wird von {:.3f} bis {:.3f} s gelesen, wo der Beschleunigungssensor da war.</translation>
    </message>
    <message>
        <source>The time steps differ too much: {} rows span {:.1f} s but most are {:.2g} s apart. Cut the recording at its gaps; the longest is between row {} at {:.3f} s and the next at {:.3f} s.</source>
        <translation>Die Zeitschritte sind zu verschieden: {} Zeilen umfassen {:.1f} s, aber die meisten liegen {:.2g} s auseinander. Zerschneiden Sie die Aufnahme an ihren Lücken; die längste liegt zwischen Zeile {} bei {:.3f} s und der nächsten bei {:.3f} s.</translation>
    </message>
    <message>
        <source>The posture leaps here within one row: rows are missing, or two recordings were joined.</source>
        <translation>Die Haltung springt hier von einer Zeile zur nächsten: Zeilen fehlen, oder zwei Aufnahmen wurden aneinandergefügt.</translation>
    </message>
    <message>
        <source>Only {:.1f} s are free of contact, so the bias of the result is subtracted; it may be out of date.</source>
        <translation>Nur {:.1f} s berühren nichts, deshalb wird der Nullpunkt des Ergebnisses abgezogen; er kann der eines anderen Tages sein.</translation>
    </message>
    <message>
        <source>In free motion {:.2g} N remain, but the sensor noise is only {:.2g} N: this is not the payload of this recording, or something else acts on the tool.</source>
        <translation>In freier Bewegung bleiben {:.2g} N übrig, wo der Sensor selbst um {:.2g} N streut: Die Last ist nicht die dieser Aufnahme, oder etwas anderes wirkt mit.</translation>
    </message>
    <message>
        <source>With these causes corrected the payload would be physically impossible, so it was left unchanged.</source>
        <translation>Ohne diese Ursachen wäre die Last unmöglich, deshalb bleibt sie, wie sie war.</translation>
    </message>
    <message>
        <source>Correcting these causes does not improve held-out segments, so the payload was left unchanged.</source>
        <translation>Diese Ursachen herauszunehmen hilft nicht, ungesehene Abschnitte vorherzusagen; deshalb bleibt die Last, wie sie war.</translation>
    </message>
    <message>
        <source>Find the unknown part first: record the motion again, more slowly.</source>
        <translation>Finden Sie zuerst, was unbekannt ist: Nehmen Sie die Bewegung noch einmal auf, langsamer.</translation>
    </message>
    <message>
        <source>Without the bound some mass would lie outside the shape; keeping it inside shifted the result by {:.1f} standard deviations.</source>
        <translation>Ohne die Grenze läge etwas Masse außerhalb der Form; sie innen zu halten verschob das Ergebnis um {:.1f} Standardabweichungen.</translation>
    </message>
    <message>
        <source>The inertia is neither estimated nor given; a typical tool size was assumed for it.</source>
        <translation>Die Trägheit ist weder bestimmt noch angegeben; die eines Werkzeugs üblicher Größe wurde angenommen.</translation>
    </message>
    <message>
        <source>an axis in the plane of the tool&apos;s flat side</source>
        <translation>eine Achse in der flachen Seite des Werkzeugs</translation>
    </message>
    <message>
        <source>the axis perpendicular to the tool&apos;s flat side</source>
        <translation>die Achse senkrecht zur flachen Seite des Werkzeugs</translation>
    </message>
    <message>
        <source>Recording {} contradicts the others: {:.3f} kg against {:.3f} kg, centre of mass {:.0f} mm apart. It was excluded.</source>
        <translation>Aufnahme {} widerspricht den anderen: {:.3f} kg gegen {:.3f} kg, Schwerpunkte {:.0f} mm auseinander. Sie wurde ausgelassen.</translation>
    </message>
    <message>
        <source>With two recordings it is not clear which one has the right tool: check both.</source>
        <translation>Bei zwei Aufnahmen kann niemand sagen, welche vom richtigen Werkzeug ist: Prüfen Sie beide.</translation>
    </message>
    <message>
        <source>Estimate it separately.</source>
        <translation>Werten Sie sie für sich allein aus.</translation>
    </message>
    <message>
        <source>{:.1f} s of {:.1f} s look like contact and were excluded: {}.</source>
        <translation>{:.1f} s von {:.1f} s sahen nach Kontakt aus und wurden ausgelassen: {}.</translation>
    </message>
    <message>
        <source>This is too little free motion for a reliable result: check the marks, or record a longer free segment.</source>
        <translation>Bei so wenig freier Bewegung ist das Vertrauen gering: Prüfen Sie die Markierungen, oder nehmen Sie einen längeren freien Teil auf.</translation>
    </message>
    <message>
        <source>Trust is low: the true values may lie outside the intervals. Look where the residual is large.</source>
        <translation>Das Vertrauen ist gering: Die wahren Werte können außerhalb der Bereiche liegen. Sehen Sie nach, wo die Differenz groß ist.</translation>
    </message>
    <message>
        <source>Your input disagrees with the measurement: {}.</source>
        <translation>Ihre Angaben und die Bewegung widersprechen sich bei: {}.</translation>
    </message>
    <message>
        <source>Check that the values are for this tool and position, and the sensor&apos;s calibration. Trust is low.</source>
        <translation>Entweder gehören die Angaben zu einem anderen Werkzeug oder Ort, oder die Kalibrierung des Sensors stimmt nicht: Das Vertrauen ist gering.</translation>
    </message>
    <message>
        <source>The estimated mass is {:.0f} % off the known one, far outside its interval.</source>
        <translation>Die bestimmte Masse weicht um {:.0f} % von der bekannten ab, weit außerhalb ihres Bereichs.</translation>
    </message>
    <message>
        <source>Check that the known value is for this tool, and the sensor&apos;s calibration. Trust is low.</source>
        <translation>Entweder gehört der bekannte Wert zu einem anderen Werkzeug, oder die Kalibrierung des Sensors stimmt nicht: Das Vertrauen ist gering.</translation>
    </message>
    <message>
        <source>Tilt the tool in several directions.</source>
        <translation>Neigen Sie das Werkzeug in mehrere Richtungen.</translation>
    </message>
    <message>
        <source>Rotate the tool faster, or specify its shape.</source>
        <translation>Drehen Sie das Werkzeug schneller, oder geben Sie seine Form an.</translation>
    </message>
    <message>
        <source>These values come mainly from your input, not from the motion: {}.</source>
        <translation>Die Bewegung sagt weniger als Ihre Angaben über: {}. Diese Zahlen sind überwiegend Ihre eigenen.</translation>
    </message>
    <message>
        <source>These values are physically impossible: {}</source>
        <translation>Kein wirklicher Körper hat diese Zahlen: {}</translation>
    </message>
    <message>
        <source>No position was recorded. The forces fit a rotation about a point {:.2g} m away, so the sensor&apos;s acceleration was taken from that rotation.</source>
        <translation>Die Kräfte passen zu einem Sensor, der um einen {:.2g} m entfernten Punkt schwingt; seine Beschleunigung wurde daraus genommen statt null.</translation>
    </message>
    <message>
        <source>Contact leaves only {:.1f} s inside the trimmed range, so the free segments at the ends of the recording are used, too.</source>
        <translation>Der Kontakt lässt im beschnittenen Bereich nur {:.1f} s übrig, deshalb werden auch die freien Teile an den Enden der Aufnahme benutzt.</translation>
    </message>
    <message>
        <source>Use --trim to exclude them.</source>
        <translation>Mit --trim bleiben sie draußen.</translation>
    </message>
    <message>
        <source>The tool did not move.</source>
        <translation>Das Werkzeug stand die ganze Zeit still.</translation>
    </message>
    <message>
        <source>Tilt it in several directions: at rest, its weight and the sensor&apos;s bias cannot be separated.</source>
        <translation>Neigen Sie es in mehrere Richtungen: In Ruhe sehen sein Gewicht und der Nullpunkt des Sensors gleich aus.</translation>
    </message>
    <message>
        <source>Check the shape&apos;s size and position.</source>
        <translation>Prüfen Sie Größe und Platz der Form.</translation>
    </message>
    <message>
        <source>The shape does not match the measurement: a tool of that shape and position would have caused other forces.</source>
        <translation>Form und gemessene Bewegung widersprechen sich: Ein Werkzeug dieser Form an diesem Platz hätte den Sensor anders bewegt.</translation>
    </message>
    <message>
        <source>Check its size and position, or remove it.</source>
        <translation>Prüfen Sie Größe und Platz der Form, oder lassen Sie sie weg.</translation>
    </message>
    <message>
        <source>Check its size and position, or choose &quot;rough&quot;.</source>
        <translation>Prüfen Sie Größe und Platz der Form, oder wählen Sie „ungefähr“.</translation>
    </message>
    <message>
        <source>The payload weighs {:.3f} kg; the robot is rated for {} kg.</source>
        <translation>Die Last wiegt {:.3f} kg; der Roboter ist für {} kg gebaut.</translation>
    </message>
    <message>
        <source>An inertia entry is {:.4g} kg m2; set_target_payload accepts at most {} kg m2.</source>
        <translation>Ein Eintrag der Trägheit ist {:.4g} kg m²; set_target_payload nimmt höchstens {} kg m².</translation>
    </message>
    <message>
        <source>Set it in Desk, or specify it before exporting.</source>
        <translation>Setzen Sie ihn in Desk, oder geben Sie ihn vor dem Export an.</translation>
    </message>
    <message>
        <source>the format of the profile and the unit of its angles (zeros are written)</source>
        <translation>die Form des Profils und die Einheit seiner Winkel (es werden Nullen geschrieben)</translation>
    </message>
    <message>
        <source>The sensor&apos;s parent link {} is not known to be a flange; it was taken as the flange.</source>
        <translation>Das Glied {}, an dem der Sensor sitzt, ist nicht als Flansch bekannt und wurde dafür genommen.</translation>
    </message>
    <message>
        <source>If it is not, specify the sensor&apos;s pose on the flange.</source>
        <translation>Geben Sie die Lage des Sensors am Flansch an, wenn das nicht stimmt.</translation>
    </message>
    <message>
        <source>Record a motion that rotates the tool faster, or specify its shape, before you rely on these values.</source>
        <translation>Nehmen Sie eine Bewegung auf, die das Werkzeug schneller dreht, oder nennen Sie seine Form, bevor Sie diesen Zahlen trauen.</translation>
    </message>
    <message>
        <source>From the shape or values that you entered, not measured: {}.</source>
        <translation>Aus Form oder Angaben von Ihnen, nicht gemessen: {}.</translation>
    </message>
    <message>
        <source>Check them before the robot uses them.</source>
        <translation>Prüfen Sie sie, bevor der Roboter sich darauf verlässt.</translation>
    </message>
    <message>
        <source>The result does not state where the sensor is mounted; the sensor frame was taken as the flange frame.</source>
        <translation>Das Ergebnis sagt nicht, wo der Sensor sitzt; seine Achsen wurden für die des Flansches genommen.</translation>
    </message>
    <message>
        <source>Specify the sensor&apos;s pose on the flange.</source>
        <translation>Geben Sie die Lage des Sensors am Flansch an.</translation>
    </message>
    <message>
        <source>The estimate is marked as physically impossible.</source>
        <translation>Die Bestimmung sagt selbst, dass ihr Ergebnis körperlich nicht möglich ist.</translation>
    </message>
    <message>
        <source>Use the method map, or a longer recording that rotates the tool faster.</source>
        <translation>Nehmen Sie das Verfahren map, oder eine längere Aufnahme, die das Werkzeug schneller dreht.</translation>
    </message>
    <message>
        <source>The HDF5 file is damaged; only the datasets that could be reached were read.</source>
        <translation>Die HDF5-Datei ist beschädigt; gelesen wurden die Datensätze, die erreichbar sind.</translation>
    </message>
    <message>
        <source>Write each quantity as a dataset of numbers with one row per sample.</source>
        <translation>Schreiben Sie jede Größe als Datensatz von Zahlen mit einer Zeile je Messung.</translation>
    </message>
    <message>
        <source>Skipped, since they are not tables of numbers: {}.</source>
        <translation>Ausgelassen, weil es keine Zahlentabellen sind: {}.</translation>
    </message>
    <message>
        <source>There is no {} beside the recording; defaults are used: wrench of the sensor on the payload, gravity (0, 0, -9.81) m/s2.</source>
        <translation>Neben der Aufnahme fehlt {}; es gelten die Voreinstellungen: Kraft des Sensors auf die Last, Schwerkraft (0, 0, −9,81) m/s².</translation>
    </message>
    <message>
        <source>The time stamps of {} are on another clock: {:.4f} s were added, based on when its messages arrived.</source>
        <translation>Die Zeitstempel von {} laufen nach einer anderen Uhr: {:.4f} s wurden addiert, nach der Ankunft der Nachrichten.</translation>
    </message>
    <message>
        <source>{} samples of {} were not in time order and were sorted.</source>
        <translation>{} Messungen von {} standen nicht in der Reihenfolge ihrer Zeiten und wurden sortiert.</translation>
    </message>
    <message>
        <source>Found by matching the force to the motion; this also removes any delay of the sensor itself.</source>
        <translation>Gefunden, indem die Kraft der Bewegung folgt; eine Verspätung des Sensors selbst ist damit auch herausgenommen.</translation>
    </message>
    <message>
        <source>At {} of {} times one of the streams has a gap; these were left out.</source>
        <translation>Zu {} von {} Zeiten hat einer der Ströme eine Lücke; sie wurden ausgelassen.</translation>
    </message>
    <message>
        <source>The poses are those of the flange; the sensor&apos;s poses are derived from its mount.</source>
        <translation>Die Posen sind die des Flansches; die des Sensors folgen aus seiner Befestigung.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is not a label ({} such rows, read as not labelled).</source>
        <translation>„{}“ ist keine Markierung ({} solche Zeilen, als nicht markiert gelesen).</translation>
    </message>
    <message>
        <source>{} of {} lines are not JSON objects and were left out.</source>
        <translation>{} von {} Zeilen sind keine JSON-Objekte und wurden ausgelassen.</translation>
    </message>
    <message>
        <source>Estimate the parts before and after separately.</source>
        <translation>Werten Sie vorher und nachher getrennt aus.</translation>
    </message>
    <message>
        <source>From {:.1f} s on, the tool is again the earlier one of {:.2f} kg.</source>
        <translation>Ab {:.1f} s ist es wieder das Werkzeug von vorher, mit {:.2f} kg.</translation>
    </message>
    <message>
        <source>{} samples were not usable: not finite, without motion, or with a time that does not increase.</source>
        <translation>{} Messungen waren nicht brauchbar: nicht endlich, ohne Bewegung, oder mit einer Zeit, die nicht steigt.</translation>
    </message>
    <message>
        <source>{:.1f} s look like contact and were excluded, {:.1f} s were free: trust is low.</source>
        <translation>{:.1f} s sahen nach Kontakt aus und wurden ausgelassen, {:.1f} s waren frei: Das Vertrauen ist gering.</translation>
    </message>
    <message>
        <source>{}: {} triangles faced the opposite way to their neighbours and were flipped.</source>
        <translation>{}: {} Dreiecke zeigten anders herum als ihre Nachbarn und wurden gedreht.</translation>
    </message>
    <message>
        <source>{} is inside-out ({} of {} closed pieces); it was flipped.</source>
        <translation>{} ist umgestülpt ({} von {} geschlossenen Teilen); es wurde gewendet.</translation>
    </message>
    <message>
        <source>{}: {:.0f} % of the volume is counted twice because parts overlap.</source>
        <translation>{}: {:.0f} % des Volumens zählen doppelt, weil Teile sich überlappen.</translation>
    </message>
    <message>
        <source>Column {} is missing, so the joints are ignored and the sensor&apos;s pose is used.</source>
        <translation>Spalte {} fehlt, deshalb bleiben die Gelenke beiseite und die Sensorpose wird benutzt.</translation>
    </message>
    <message>
        <source>Column {} is missing, so the sensor&apos;s pose is ignored and the joints are used.</source>
        <translation>Spalte {} fehlt, deshalb bleibt die Sensorpose beiseite und die Gelenke werden benutzt.</translation>
    </message>
    <message>
        <source>Column {} is missing, so the position is ignored and the joints are used.</source>
        <translation>Spalte {} fehlt, deshalb bleibt der Ort beiseite und die Gelenke werden benutzt.</translation>
    </message>
    <message>
        <source>A position without an orientation is ignored.</source>
        <translation>Ein Ort ohne Ausrichtung bleibt beiseite.</translation>
    </message>
    <message>
        <source>The joint velocities do not match the joints one by one and are ignored.</source>
        <translation>Die Gelenkgeschwindigkeiten passen nicht einzeln zu den Gelenken und bleiben beiseite.</translation>
    </message>
    <message>
        <source>The twist is incomplete or without an orientation and is ignored.</source>
        <translation>Die Geschwindigkeit des Sensors ist unvollständig oder ohne Ausrichtung und bleibt beiseite.</translation>
    </message>
    <message>
        <source>{} column is kept but not used: {}.</source>
        <translation>{} Spalte bleibt unbenutzt beiseite: {}.</translation>
    </message>
    <message>
        <source>{} columns are kept but not used: {}{}.</source>
        <translation>{} Spalten bleiben unbenutzt beiseite: {}{}.</translation>
    </message>
    <message>
        <source>{} missing in {} of {} rows and not used.</source>
        <translation>{} in {} von {} Zeilen und bleiben beiseite.</translation>
    </message>
    <message>
        <source>The later mark takes precedence; correct their limits.</source>
        <translation>Die spätere Markierung zählt; berichtigen Sie ihre Grenzen.</translation>
    </message>
    <message>
        <source>The estimated bias then includes the weight in that posture.</source>
        <translation>Der bestimmte Nullpunkt enthält dann das Gewicht in jener Haltung.</translation>
    </message>
    <message>
        <source>Mass and centre of mass can still be estimated; record at a higher rate for the inertia.</source>
        <translation>Masse und Schwerpunkt sind trotzdem zu haben; für die Trägheit nehmen Sie schneller auf.</translation>
    </message>
    <message>
        <source>Samples were lost there; the motion is interpolated across the gap.</source>
        <translation>Dort gingen Messwerte verloren; die Bewegung ist durch Interpolation überbrückt.</translation>
    </message>
    <message>
        <source>The time of the standing poses is missing or does not increase; they are numbered 0, 1, 2, ... instead.</source>
        <translation>Die Zeit der stehenden Posen fehlt oder steigt nicht; sie sind stattdessen 0, 1, 2, ... nummeriert.</translation>
    </message>
    <message>
        <source>joint &quot;{}&quot; mimics &quot;{}&quot;, which is not another joint</source>
        <translation>Gelenk „{}“ ahmt „{}“ nach, das kein anderes Gelenk ist.</translation>
    </message>
    <message>
        <source>link &quot;{}&quot; is in a closed loop that is connected to nothing</source>
        <translation>Glied „{}“ liegt in einem geschlossenen Ring, der an nichts hängt.</translation>
    </message>
    <message>
        <source>All rows were requested.</source>
        <translation>Alle Zeilen waren verlangt.</translation>
    </message>
    <message>
        <source>No motion from this posture stays within all limits. Bring the joints to mid-range first.</source>
        <translation>Keine Bewegung aus dieser Haltung hält alle Grenzen ein. Bringen Sie den Arm zuerst in die Mitte seiner Gelenkbereiche.</translation>
    </message>
    <message>
        <source>This motion exceeds the limits from here. Bring the joints to mid-range first.</source>
        <translation>Diese Bewegung hält von hier aus die Grenzen nicht ein. Bringen Sie den Arm in die Mitte seiner Gelenkbereiche.</translation>
    </message>
    <message>
        <source>Checking individual readings</source>
        <translation>Einzelne Messwerte werden geprüft</translation>
    </message>
    <message>
        <source>Measuring the improvement on held-out segments</source>
        <translation>Der Gewinn auf ungesehenen Abschnitten wird gemessen</translation>
    </message>
    <message>
        <source>Testing causes</source>
        <translation>Ursachen werden ausprobiert</translation>
    </message>
    <message>
        <source>Comparing alternatives</source>
        <translation>Andere Erklärungen werden verglichen</translation>
    </message>
    <message>
        <source>Running the search on simulated clean recordings</source>
        <translation>Die Suche wird an simulierten sauberen Aufnahmen erprobt</translation>
    </message>
    <message>
        <source>Only {:.1f} s of the recording can be checked; at least 2 s without contact are needed.</source>
        <translation>Nur {:.1f} s der Aufnahme lassen sich beurteilen; mindestens 2 s ohne Berührung sind nötig.</translation>
    </message>
    <message>
        <source>Not enough free motion: of {:.1f} s only {:.1f} s are free inside the trimmed range. Check the marks, or lower the trim.</source>
        <translation>Es bleibt keine freie Bewegung für die Schätzung: Von {:.1f} s berühren im beschnittenen Bereich nur {:.1f} s nichts. Prüfen Sie die Markierungen, oder beschneiden Sie weniger.</translation>
    </message>
    <message>
        <source>There are only {} standing poses; at least 6 with different tilts are needed.</source>
        <translation>Es gibt nur {} stehende Posen; mindestens 6 in verschiedenen Neigungen sind nötig.</translation>
    </message>
    <message>
        <source>Computing the motion</source>
        <translation>Die Bewegung wird berechnet</translation>
    </message>
    <message>
        <source>{} is a {} file, which holds no payload; give the --json file of &apos;heft estimate&apos; or the --result file of &apos;heft diagnose&apos;.</source>
        <translation>{} ist eine {}-Datei, aus der keine Last genommen wird; geben Sie die mit --json geschriebene Datei von „heft estimate“ oder die mit --result geschriebene von „heft diagnose“ an.</translation>
    </message>
    <message>
        <source>this is not a regular file.</source>
        <translation>das ist keine gewöhnliche Datei.</translation>
    </message>
    <message>
        <source>Close the file in the recording program before copying it; &quot;h5clear -s FILE&quot; may repair it.</source>
        <translation>Schließen Sie die Datei im Aufnahmeprogramm, bevor Sie sie kopieren; „h5clear -s DATEI“ kann sie vielleicht retten.</translation>
    </message>
    <message>
        <source>the recording does not fit into memory.</source>
        <translation>die Aufnahme passt nicht in den Speicher.</translation>
    </message>
    <message>
        <source>it contains nothing that Heft can read.</source>
        <translation>es ist nichts darin, was Heft lesen kann.</translation>
    </message>
    <message>
        <source>Was the file changed in the meantime?</source>
        <translation>Wurde die Datei inzwischen geändert?</translation>
    </message>
    <message>
        <source>the clocks of {} and {} have nothing in common, and the data do not show the offset between them.</source>
        <translation>die Uhren von {} und {} haben nichts gemeinsam, und aus den Daten geht nicht hervor, um wie viel die eine nachgeht.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is not a column of a recording.</source>
        <translation>„{}“ ist keine Spalte einer Aufnahme.</translation>
    </message>
    <message>
        <source>this is not an MCAP file.</source>
        <translation>das ist keine MCAP-Datei.</translation>
    </message>
    <message>
        <source>Its first eight bytes do not match.</source>
        <translation>Ihre ersten acht Bytes sind andere.</translation>
    </message>
    <message>
        <source>A bag has the tables topics and messages.</source>
        <translation>So ein Bag hat die Tabellen topics und messages.</translation>
    </message>
    <message>
        <source>The recorder was probably killed; &apos;rosbag reindex&apos; repairs the bag for other programs.</source>
        <translation>Die Aufnahme wurde vermutlich hart beendet; „rosbag reindex“ repariert das Bag für andere Programme.</translation>
    </message>
    <message>
        <source>Convert it to format 2.0 with &apos;rosbag fix&apos; first.</source>
        <translation>Bringen Sie es zuerst mit „rosbag fix“ auf Format 2.0.</translation>
    </message>
    <message>
        <source>the table holds more cells than fit in memory.</source>
        <translation>die Tabelle enthält mehr Zellen, als in den Speicher passen.</translation>
    </message>
    <message>
        <source>the file holds more numbers than fit in memory.</source>
        <translation>die Datei enthält mehr Zahlen, als in den Speicher passen.</translation>
    </message>
    <message>
        <source>JSON recordings have one object per line.</source>
        <translation>JSON-Aufnahmen haben ein Objekt je Zeile.</translation>
    </message>
    <message>
        <source>The connection to {}:{} was lost; reconnecting.</source>
        <translation>Die Verbindung zu {}:{} ist abgerissen; sie wird wieder versucht.</translation>
    </message>
    <message>
        <source>{} is connected, but no topic with joint states or a wrench is publishing.</source>
        <translation>{} ist verbunden, aber kein Topic mit Gelenkwinkeln oder Kräften sendet.</translation>
    </message>
    <message>
        <source>{} is connected, but its topics publish nothing.</source>
        <translation>{} ist verbunden, aber seine Topics senden nichts.</translation>
    </message>
    <message>
        <source>is not an address of this machine</source>
        <translation>ist keine Adresse dieses Rechners</translation>
    </message>
    <message>
        <source>{} sends nothing. Is RDT enabled on its web page? Is another program using the stream? It serves only one client.</source>
        <translation>{} sendet nichts. Ist RDT auf seiner Webseite eingeschaltet, und nimmt kein anderes Programm den Datenstrom? Der Sensor bedient nur eines.</translation>
    </message>
    <message>
        <source>{} already exists; a recording never overwrites a file. Choose another name.</source>
        <translation>{} gibt es schon; eine Aufnahme ersetzt nie eine Datei. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>{} cannot be created: {}.</source>
        <translation>{} lässt sich nicht anlegen: {}.</translation>
    </message>
    <message>
        <source>{} can no longer be written: {}. What was written so far can be read.</source>
        <translation>{} lässt sich nicht weiterschreiben: {}. Was da ist, ist lesbar.</translation>
    </message>
    <message>
        <source>cpf and cpt, the counts per newton and per newton metre, must be given together.</source>
        <translation>cpf und cpt, die Zählschritte je Newton und je Newtonmeter, gehören zusammen.</translation>
    </message>
    <message>
        <source>{}: The mesh cannot be read: its PLY header never ends.</source>
        <translation>{}: Das Netz lässt sich nicht lesen: Ihm fehlt ein vollständiger PLY-Kopf.</translation>
    </message>
    <message>
        <source>The recording has {} rows; at least {} are needed to compute the motion.</source>
        <translation>Die Aufnahme hat {} Zeilen; mindestens {} sind nötig, um zu wissen, wie sich das Werkzeug bewegt hat.</translation>
    </message>
    <message>
        <source>The robot &quot;{}&quot; has {} joints; at most 7 are supported.</source>
        <translation>Der Roboter „{}“ hat {} Gelenke; höchstens 7 können verfolgt werden.</translation>
    </message>
    <message>
        <source>the pose is not a rotation and a translation.</source>
        <translation>die Pose ist keine Drehung mit Verschiebung.</translation>
    </message>
    <message>
        <source>a tube is hollow already: leave out the wall, or use a cylinder.</source>
        <translation>ein Rohr ist schon hohl: Lassen Sie die Wand weg, oder nehmen Sie einen Zylinder.</translation>
    </message>
    <message>
        <source>column {} appears twice: also as column {}.</source>
        <translation>Spalte {} gibt es zweimal: auch als Spalte {}.</translation>
    </message>
    <message>
        <source>{} rows of {} columns exceed the {} million numbers that fit in memory.</source>
        <translation>{} Zeilen mit {} Spalten sind mehr als die {} Millionen Zahlen, die in den Speicher passen.</translation>
    </message>
    <message>
        <source>it contains no sample.</source>
        <translation>es gibt keine Messwerte.</translation>
    </message>
    <message>
        <source>A recording starts with a row of column names, followed by one row per sample.</source>
        <translation>Eine Aufnahme beginnt mit einer Zeile von Spaltennamen, danach kommt je Messwert eine Zeile.</translation>
    </message>
    <message>
        <source>the first line is {} MB long and not a header.</source>
        <translation>die erste Zeile ist {} MB lang und keine Kopfzeile.</translation>
    </message>
    <message>
        <source>{:.6g} m/s2 is not the gravity of any planet</source>
        <translation>{:.6g} m/s2 ist auf keinem Planeten die Schwerkraft</translation>
    </message>
    <message>
        <source>a centre of mass {:.6g} m from the sensor is not plausible</source>
        <translation>ein Schwerpunkt {:.6g} m vom Sensor entfernt kann nicht sein</translation>
    </message>
    <message>
        <source>time decreases from {} s to {} s.</source>
        <translation>die Zeit fällt von {} s auf {} s.</translation>
    </message>
    <message>
        <source>Time must increase from row to row: split the file there if two recordings were joined, or sort the rows.</source>
        <translation>Die Zeit muss von Zeile zu Zeile steigen: Teilen Sie die Datei dort, wenn zwei Aufnahmen aneinandergefügt wurden, oder sortieren Sie die Zeilen.</translation>
    </message>
    <message>
        <source>the time increases by {:.6g} s from row to row (median).</source>
        <translation>die Zeit steigt von Zeile zu Zeile um {:.6g} s (Median).</translation>
    </message>
    <message>
        <source>attribute &quot;{}&quot; appears twice in &lt;{}&gt;.</source>
        <translation>Attribut „{}“ steht in &lt;{}&gt; zweimal.</translation>
    </message>
    <message>
        <source>{} is not a session of Heft Studio: its &quot;schema&quot; should be &quot;{}{}&quot;.</source>
        <translation>{} ist keine Sitzung von Heft Studio: &quot;schema&quot; sollte dort &quot;{}{}&quot; sein.</translation>
    </message>
    <message>
        <source>The corrections of this session come from a diagnosis that this version of Heft does not understand; run the reality check again.</source>
        <translation>Die Berichtigungen dieser Sitzung stammen aus einer Realitätsprüfung, die diese Heft-Version nicht versteht; führen Sie die Realitätsprüfung noch einmal aus.</translation>
    </message>
    <message>
        <source>The difference rises or falls slowly over the whole recording, whatever the motion.</source>
        <translation>Die Abweichung steigt oder sinkt langsam über die ganze Aufnahme und kümmert sich nicht um die Bewegung.</translation>
    </message>
    <message>
        <source>Shake the tool quickly for ten seconds, two to four times per second.</source>
        <translation>Das Werkzeug zehn Sekunden lang schnell schütteln, zwei- bis viermal pro Sekunde.</translation>
    </message>
    <message>
        <source>The difference is large where the force changes fast and zero where it is constant; peaks keep their full height.</source>
        <translation>Die Abweichung ist groß, wo sich die Kraft schnell ändert, und null, wo sie ruht; die Höhe bleibt erhalten.</translation>
    </message>
    <message>
        <source>Record the raw joint angles at the full rate, without smoothing.</source>
        <translation>Die reinen Gelenkwinkel mit voller Rate aufnehmen, ohne Glättung.</translation>
    </message>
    <message>
        <source>Turn the tool slowly through large angles: late readings still show then, late accelerations do not.</source>
        <translation>Das Werkzeug langsam um große Winkel drehen: Verspätete Messwerte zeigen sich auch dann, verspätete Beschleunigungen nicht.</translation>
    </message>
    <message>
        <source>The difference changes sign whenever the motion reverses, at any speed.</source>
        <translation>Die Abweichung springt auf die andere Seite, sobald die Bewegung umkehrt, bei jedem Tempo.</translation>
    </message>
    <message>
        <source>After each stop the difference keeps oscillating for a while, at a few hertz.</source>
        <translation>Nach jedem Halt schwingt die Abweichung eine Weile nach, einige Male pro Sekunde.</translation>
    </message>
    <message>
        <source>Nothing fits: the simulated curves run opposite to the measured ones.</source>
        <translation>Nichts passt: Die simulierten Kurven laufen den gemessenen entgegen.</translation>
    </message>
    <message>
        <source>Not needed: the readings show it.</source>
        <translation>Keine ist nötig: Die Messwerte zeigen es.</translation>
    </message>
    <message>
        <source>Not needed: the time stamps show it.</source>
        <translation>Keine nötig: Die Zeitstempel zeigen es.</translation>
    </message>
    <message>
        <source>The measured curve rises in steps where the simulated one is smooth.</source>
        <translation>Die gemessene Kurve steigt in Stufen, wo die simulierte glatt ist.</translation>
    </message>
    <message>
        <source>Orientations are stored inverted: base in sensor instead of sensor in base.</source>
        <translation>Die Orientierungen sind umgekehrt gespeichert: Basis im Sensor statt Sensor in der Basis.</translation>
    </message>
    <message>
        <source>A cable or hose pulls the tool towards one point: {} N per metre.</source>
        <translation>Ein Kabel oder Schlauch zieht das Werkzeug zu einer Stelle hin: {} N pro Meter.</translation>
    </message>
    <message>
        <source>The tool&apos;s mount is flexible and rings at {} Hz.</source>
        <translation>Die Montage des Werkzeugs gibt nach und klingt mit {} Hz.</translation>
    </message>
    <message>
        <source>Reverse gravity_m_s2 in the setup file.</source>
        <translation>Kehren Sie gravity_m_s2 in der Aufbaudatei um.</translation>
    </message>
    <message>
        <source>slow oscillation, {:.1f} to {:.0f} times per second</source>
        <translation>langsamem Schwingen, {:.1f}- bis {:.0f}-mal in der Sekunde</translation>
    </message>
    <message>
        <source>The tool was never rotated fast enough about {}: rotate it back and forth about that axis, faster.</source>
        <translation>Das Werkzeug wurde nie schnell genug um {} gedreht: Drehen Sie es um diese Achse hin und her, schneller.</translation>
    </message>
    <message>
        <source>{} is not a setup file.</source>
        <translation>{} ist keine Aufbaudatei.</translation>
    </message>
    <message>
        <source>the size of the load</source>
        <translation>der Größe der Last</translation>
    </message>
    <message>
        <source>how fast the rotation changes</source>
        <translation>dem Wechsel des Drehtempos</translation>
    </message>
    <message>
        <source>{} cannot be written as fast as samples arrive. What was written so far can be read.</source>
        <translation>{} kann nicht so schnell geschrieben werden, wie Messwerte kommen. Was schon da ist, lässt sich lesen.</translation>
    </message>
    <message>
        <source>Rotational stiffness k</source>
        <translation>Steifigkeit gegen Drehen k</translation>
    </message>
    <message>
        <source>Rotational drag d</source>
        <translation>Widerstand gegen Drehen d</translation>
    </message>
    <message>
        <source>Rotational friction M</source>
        <translation>Reibung gegen Drehen M</translation>
    </message>
    <message>
        <source>Displacement before it slips s</source>
        <translation>Weg, bis es rutscht s</translation>
    </message>
    <message>
        <source>Time t</source>
        <translation>Zum Zeitpunkt t</translation>
    </message>
    <message>
        <source>Position from the sensor, {0}</source>
        <translation>Ort vom Sensor aus, {0}</translation>
    </message>
    <message>
        <source>Tilt about {0}</source>
        <translation>Gekippt um {0}</translation>
    </message>
    <message>
        <source>Attachment point, {0}</source>
        <translation>Ort, von dem es zieht, {0}</translation>
    </message>
    <message>
        <source>Rotation about {}</source>
        <translation>Gedreht um {}</translation>
    </message>
    <message>
        <source>Offset along {}</source>
        <translation>Verschoben entlang {}</translation>
    </message>
    <message>
        <source>Gain error of {}</source>
        <translation>Verstärkung daneben, {}</translation>
    </message>
    <message>
        <source>Angle error of joint {}</source>
        <translation>Winkel daneben, Gelenk {}</translation>
    </message>
    <message>
        <source>this is not a JSON object.</source>
        <translation>das ist kein JSON-Objekt.</translation>
    </message>
    <message>
        <source>&quot;use&quot; is not an object.</source>
        <translation>„use“ ist kein Objekt.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; in &quot;use&quot; is not a text.</source>
        <translation>„{}“ in „use“ ist kein Text.</translation>
    </message>
    <message>
        <source>&quot;scale&quot; is not an object of numbers.</source>
        <translation>„scale“ ist kein Objekt aus Zahlen.</translation>
    </message>
    <message>
        <source>&quot;offset_s&quot; is not an object of numbers.</source>
        <translation>„offset_s“ ist kein Objekt aus Zahlen.</translation>
    </message>
    <message>
        <source>&quot;join&quot; is not a list of files.</source>
        <translation>„join“ ist keine Liste von Dateien.</translation>
    </message>
    <message>
        <source>Shortfall near the range limit, {}</source>
        <translation>Fehlt nahe dem Ende des Messbereichs, {}</translation>
    </message>
    <message>
        <source>Width of that region, as a share of the range, {}</source>
        <translation>Welcher Teil des Bereichs das ist, {}</translation>
    </message>
    <message>
        <source>Remembered share</source>
        <translation>Gemerkter Anteil</translation>
    </message>
    <message>
        <source>Fades after, as a share of the load&apos;s range</source>
        <translation>Vergessen nach, vom Bereich der Last</translation>
    </message>
    <message>
        <source>Gain of {}, difference between directions</source>
        <translation>Verstärkung von {}, zu einer Seite mehr</translation>
    </message>
    <message>
        <source>With these causes corrected the payload would change by a quarter or more while something unknown remains, so it was left unchanged.</source>
        <translation>Ohne diese Ursachen wäre die Last um ein Viertel leichter oder schwerer, während etwas Unbekanntes bleibt; deshalb bleibt sie, wie sie war.</translation>
    </message>
    <message>
        <source>Switch off what runs nearby, such as a fan or a motor, and record again.</source>
        <translation>Schalten Sie ab, was in der Nähe läuft, etwa einen Lüfter oder Motor, und nehmen Sie noch einmal auf.</translation>
    </message>
    <message>
        <source>The motion was smoothed before it was recorded, by {} ms to either side, so its fast parts are too small.</source>
        <translation>Die Bewegung wurde vor der Aufnahme geglättet, um {} ms zu beiden Seiten, sodass Schnelles darin zu klein ist.</translation>
    </message>
    <message>
        <source>Swing force at the start along {0}</source>
        <translation>Kraft der Schwingung am Anfang längs {0}</translation>
    </message>
    <message>
        <source>The same a quarter period later along {0}</source>
        <translation>Dieselbe eine Viertelschwingung später längs {0}</translation>
    </message>
    <message>
        <source>A cable or hose, fixed at one point and {} mm long when slack, pulls the tool back: {} N per metre.</source>
        <translation>Ein Kabel oder Schlauch, an einer Stelle befestigt und schlaff {} mm lang, zieht das Werkzeug zurück: {} N je Meter.</translation>
    </message>
    <message>
        <source>Gain error of all forces</source>
        <translation>Verstärkung aller Kräfte daneben um</translation>
    </message>
    <message>
        <source>Clock drift</source>
        <translation>Uhren laufen auseinander um</translation>
    </message>
    <message>
        <source>Height of the loop, as a share of the load&apos;s range</source>
        <translation>Höhe der Schleife, vom Bereich der Last</translation>
    </message>
    <message>
        <source>Gain change of {}</source>
        <translation>Verstärkung ändert sich, {}</translation>
    </message>
    <message>
        <source>Angle error of joint {}, sine part</source>
        <translation>Winkel daneben, Gelenk {}, mal seinem Sinus</translation>
    </message>
    <message>
        <source>Angle error of joint {}, cosine part</source>
        <translation>Winkel daneben, Gelenk {}, mal seinem Kosinus</translation>
    </message>
    <message>
        <source>the motor of joint {:.0f}</source>
        <translation>dem, was der Motor von Gelenk {:.0f} tut</translation>
    </message>
    <message>
        <source>{} reads exactly {:.4g} {} wherever it is within {:.2g} of that value: {:.0f} % of its readings.</source>
        <translation>{} zeigt genau {:.4g} {}, wo immer es weniger als {:.2g} davon entfernt wäre: {:.0f} % der Messwerte.</translation>
    </message>
    <message>
        <source>Switch off the threshold or dead band in the sensor&apos;s driver and record again.</source>
        <translation>Schalten Sie die Schwelle (Totzone) im Treiber des Sensors ab und nehmen Sie noch einmal auf.</translation>
    </message>
    <message>
        <source>{} stays the same in nearly all rows: it was not measured, or a threshold in the sensor&apos;s driver hides small values. Fix that and record again.</source>
        <translation>{} bleibt in fast allen Zeilen gleich: Der Kanal wurde nicht gemessen, oder eine Schwelle im Treiber des Sensors verbirgt, was klein ist. Beheben Sie das und nehmen Sie noch einmal auf.</translation>
    </message>
    <message>
        <source>Gain change of all channels</source>
        <translation>Verstärkung aller Kanäle ändert sich um</translation>
    </message>
    <message>
        <source>Quadratic drag d</source>
        <translation>Widerstand nach dem Quadrat der Geschwindigkeit d</translation>
    </message>
    <message>
        <source>Extra friction at low speed F</source>
        <translation>Mehr Reibung, solange langsam, F</translation>
    </message>
    <message>
        <source>Speed below which friction rises v</source>
        <translation>Geschwindigkeit, unter der es mehr reibt, v</translation>
    </message>
    <message>
        <source>Stiffening with stretch h</source>
        <translation>Wird beim Dehnen steifer um h</translation>
    </message>
    <message>
        <source>A cable or hose, fixed at one point, pulls the tool back: {} N per metre where it starts to stretch, and more the further it stretches.</source>
        <translation>Ein Kabel oder Schlauch, an einer Stelle befestigt, zieht das Werkzeug zurück: {} N je Meter, wo es sich zu dehnen beginnt, und mehr, je weiter es sich dehnt.</translation>
    </message>
    <message>
        <source>Increasing tilt about {0}</source>
        <translation>Neigt sich weiter um {0}</translation>
    </message>
    <message>
        <source>Something, such as a bent hose, pushes the tool away from one point: {} N per metre.</source>
        <translation>Etwas, etwa ein gebogener Schlauch, drückt das Werkzeug von einer Stelle weg: {} N je Meter.</translation>
    </message>
    <message>
        <source>the size of the load, on the forces alone</source>
        <translation>der Größe der Last, bei den Kräften allein</translation>
    </message>
    <message>
        <source>The reported velocities are averaged over {} ms, so their fast parts are too small; Heft can use the positions instead.</source>
        <translation>Die gemeldeten Geschwindigkeiten sind Mittelwerte über {} ms, sodass Schnelles darin zu klein ist; Heft kann stattdessen die Positionen nehmen.</translation>
    </message>
    <message>
        <source>{} is not a result of heft diagnose; write one with heft diagnose REC --json FILE.</source>
        <translation>{} ist kein Ergebnis von heft diagnose; schreiben Sie eines mit heft diagnose REC --json DATEI.</translation>
    </message>
    <message>
        <source>Repeated readings</source>
        <translation>Erneut ausgegeben</translation>
    </message>
    <message>
        <source>Averaged over T</source>
        <translation>Mittel über T</translation>
    </message>
    <message>
        <source>{} segments, {:.1f} s in total, were excluded: something acts there, too weak to distinguish contact from other effects.</source>
        <translation>{} Abschnitte, zusammen {:.1f} s, blieben außen vor: Dort wirkt etwas, das zu schwach ist, um eine Berührung von etwas anderem zu unterscheiden.</translation>
    </message>
    <message>
        <source>Record the motion again and keep clear of everything.</source>
        <translation>Nehmen Sie die Bewegung noch einmal auf und halten Sie dabei von allem Abstand.</translation>
    </message>
    <message>
        <source>A segment of {:.1f} s was excluded: something acts there, too weak to distinguish contact from other effects.</source>
        <translation>Ein Abschnitt von {:.1f} s blieb außen vor: Dort wirkt etwas, das zu schwach ist, um eine Berührung von etwas anderem zu unterscheiden.</translation>
    </message>
    <message>
        <source>External blows, number</source>
        <translation>Von außen angestoßen, Male</translation>
    </message>
    <message>
        <source>Something struck the tool or the ground, first at {:.1f} s: the motion alone would not cause such strong ringing.</source>
        <translation>Etwas hat das Werkzeug oder den Boden angestoßen, zuerst bei {:.1f} s: Die Bewegung allein bringt nichts so stark zum Schwingen.</translation>
    </message>
    <message>
        <source>Find out what knocks, and record again without it.</source>
        <translation>Finden Sie heraus, was da anstößt, und nehmen Sie ohne das noch einmal auf.</translation>
    </message>
    <message>
        <source>Something that carries the tool is flexible and rings at {} Hz when it is struck: its mount, or the robot&apos;s pedestal.</source>
        <translation>Etwas, das das Werkzeug trägt, gibt nach und schwingt mit {} Hz, wenn es angestoßen wird: seine Befestigung oder das, worauf der Roboter steht.</translation>
    </message>
    <message>
        <source>Tap the tool, then the robot&apos;s pedestal: which of them rings at this frequency? Tighten its screws.</source>
        <translation>Klopfen Sie an das Werkzeug, dann an das, worauf der Roboter steht: Was davon klingt in dieser Tonhöhe? Ziehen Sie dort die Schrauben nach.</translation>
    </message>
    <message>
        <source>From {:.1f} to {:.1f} s the zero or the load was different again; that segment was excluded.</source>
        <translation>Von {:.1f} bis {:.1f} s war der Nullpunkt oder die Last noch einmal anders; dieser Abschnitt blieb außen vor.</translation>
    </message>
    <message>
        <source>The positions were smoothed before they were recorded, by {} ms to either side, so their fast parts are too small.</source>
        <translation>Die Positionen wurden vor der Aufzeichnung um {} ms zu beiden Seiten geglättet, sodass Schnelles in ihnen zu klein ist.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; would explain some of the misfit, but it is so small that Heft&apos;s own smoothing of the motion may cause as much. It is not reported.</source>
        <translation>„{}“ würde einen Teil der Abweichung erklären, ist aber so klein, dass unsere eigene Glättung der Bewegung ebenso viel übrig lassen kann. Es wird nicht genannt.</translation>
    </message>
    <message>
        <source>No action is needed: the estimate accounts for it.</source>
        <translation>Es ist nichts zu tun: die Last berücksichtigt es.</translation>
    </message>
    <message>
        <source>The motion was smoothed to {:.0f} Hz, since above that its accelerations are noisier than the sensor; faster effects cannot be checked.</source>
        <translation>Die Bewegung wurde auf {:.0f} Hz geglättet, weil ihre Beschleunigungen darüber stärker rauschen als der Sensor; was schneller ist, lässt sich nicht beurteilen.</translation>
    </message>
    <message>
        <source>It acts straight up: does the robot or the sensor&apos;s driver already subtract a tool&apos;s weight? If not: does a balancer or a hose carry part of it?</source>
        <translation>Es zieht genau nach oben: Zieht der Roboter oder der Treiber des Sensors das Gewicht eines Werkzeugs schon ab? Wenn nicht: Trägt ein Balancer oder ein Schlauch einen Teil davon?</translation>
    </message>
    <message>
        <source>State only one of them.</source>
        <translation>Geben Sie nur eines davon an.</translation>
    </message>
    <message>
        <source>&quot;sensor&quot; is not an object.</source>
        <translation>„sensor“ ist kein Objekt.</translation>
    </message>
    <message>
        <source>vx, vy, vz, wx, wy, wz are not used: the pose is the base&apos;s in the sensor, and the reference point and axes of the velocities are not stated.</source>
        <translation>vx, vy, vz, wx, wy, wz bleiben unbenutzt: Die Pose ist die des Sockels im Sensor, und zu welchem Punkt und welchen Achsen die Geschwindigkeiten gehören, ist nicht gesagt.</translation>
    </message>
    <message>
        <source>Angles that wrap around: whole turns were removed from {}.</source>
        <translation>Winkel, die umspringen: Ganze Umdrehungen wurden herausgenommen aus {}.</translation>
    </message>
    <message>
        <source>Recording {} is not reliable, so neither are the numbers from all of them.</source>
        <translation>Aufnahme {} ist nicht verlässlich, und damit auch nicht die Zahlen aus allen.</translation>
    </message>
    <message>
        <source>Specify its shape, or record a motion that rotates the tool faster.</source>
        <translation>Geben Sie seine Form an, oder nehmen Sie eine Bewegung auf, die das Werkzeug schneller dreht.</translation>
    </message>
    <message>
        <source>With this interpretation the model misses {:.0f} % of the force and {:.0f} % of the torque that the motion causes; as stated it misses {:.0f} % and {:.0f} %.</source>
        <translation>So gelesen verfehlt das Modell {:.0f} % dessen, was die Bewegung aus der Kraft macht, und {:.0f} % beim Moment; wie angegeben verfehlt es {:.0f} % und {:.0f} %.</translation>
    </message>
    <message>
        <source>Fits equally well: {}</source>
        <translation>Ebenso gut passt: {}</translation>
    </message>
    <message>
        <source>On held-out segments a rigid tool misses {:.0f} % of the force and {:.0f} % of the torque that the motion causes.</source>
        <translation>Auf Teilen, an die nicht angepasst wurde, verfehlt ein starres Werkzeug {:.0f} % dessen, was die Bewegung aus der Kraft macht, und {:.0f} % beim Moment.</translation>
    </message>
    <message>
        <source>The readings were interpreted differently from what is stated.</source>
        <translation>Die Messwerte wurden anders verstanden als angegeben.</translation>
    </message>
    <message>
        <source>The numbers in {} are not reliable, so no payload is written from them: see its findings first.</source>
        <translation>{} sagt, dass seinen Zahlen nicht zu trauen ist; deshalb wird daraus keine Last geschrieben: Sehen Sie sich zuerst die Befunde an.</translation>
    </message>
    <message>
        <source>The estimate&apos;s own findings say that its numbers are not reliable.</source>
        <translation>Die Schätzung selbst sagt, dass ihren Zahlen nicht zu trauen ist.</translation>
    </message>
    <message>
        <source>Read its findings before the robot uses them.</source>
        <translation>Sehen Sie sich ihre Befunde an, bevor der Roboter sich darauf verlässt.</translation>
    </message>
    <message>
        <source>The evidence is weak: another interpretation fits nearly as well. {}</source>
        <translation>Der Beleg ist schwach: Fast ebenso gut passt eine andere Lesart. {}</translation>
    </message>
    <message>
        <source>It was changed during the recording; this is the value set for longest.</source>
        <translation>Während der Aufnahme wurde er neu eingestellt; dies galt am längsten.</translation>
    </message>
    <message>
        <source>Use the name that it has on your robot.</source>
        <translation>Schreiben Sie den Namen hin, den es an Ihrem Roboter hat.</translation>
    </message>
    <message>
        <source>The link &quot;{}&quot; weighed {} kg in the URDF; the payload replaces it.</source>
        <translation>Das Glied „{}“ wog in der URDF {} kg; die Last tritt an diese Stelle.</translation>
    </message>
    <message>
        <source>{}: several publishers send on this topic ({}); the arm&apos;s joints are used.</source>
        <translation>{}: Auf diesem Topic senden mehrere ({}); genommen werden die Gelenke des Arms.</translation>
    </message>
    <message>
        <source>The velocities of {} are not numbers; they were ignored and the joint angles differentiated.</source>
        <translation>Die Geschwindigkeiten von {} sind keine Zahlen; sie wurden weggelassen und die Gelenkwinkel abgeleitet.</translation>
    </message>
    <message>
        <source>{}:{} does not answer as RTDE. Is it a Universal Robots controller, and is RTDE enabled in its security settings?</source>
        <translation>{}:{} antwortet nicht wie RTDE. Ist es eine Steuerung von Universal Robots, und ist RTDE in ihren Sicherheitseinstellungen erlaubt?</translation>
    </message>
    <message>
        <source>This controller does not send ft_raw_wrench (e-Series do from 5.9 on), and its actual_TCP_force already has the payload subtracted: the wrench must come from a separate sensor.</source>
        <translation>Diese Steuerung sendet ft_raw_wrench nicht (e-Series ab 5.9 tun das), und aus actual_TCP_force hat sie die Last schon herausgerechnet: Kraft und Drehmoment müssen von einem eigenen Sensor kommen.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is not a live source. Sources are rtde:HOST[:PORT], rdt:HOST[:PORT], foxglove:HOST[:PORT], rosbridge:HOST[:PORT], udp:[HOST:]PORT, replay:FILE and virtual:SEED.</source>
        <translation>„{}“ ist keine Live-Quelle. Quellen sind rtde:HOST[:PORT], rdt:HOST[:PORT], foxglove:HOST[:PORT], rosbridge:HOST[:PORT], udp:[HOST:]PORT, replay:DATEI und virtual:SEED.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is not a robot that Heft knows.</source>
        <translation>„{}“ ist kein Roboter, den Heft kennt.</translation>
    </message>
    <message>
        <source>{} by {:.2g} N (sensor noise: {:.2g} N)</source>
        <translation>{} um {:.2g} N (der Sensor selbst streut um {:.2g} N)</translation>
    </message>
    <message>
        <source>{} by {:.2g} N m (sensor noise: {:.2g} N m)</source>
        <translation>{} um {:.2g} N m (der Sensor selbst streut um {:.2g} N m)</translation>
    </message>
    <message>
        <source>On held-out segments the model misses {}: something other than a rigid tool affects the readings (contact, drift, delay, a cable, a poorly calibrated sensor).</source>
        <translation>Auf Strecken, die nicht zur Anpassung dienten, verfehlt das Modell {}: Etwas anderes als ein starres Werkzeug wirkt mit (Berührung, Drift, Verzögerung, ein Kabel, ein schlecht kalibrierter Sensor).</translation>
    </message>
    <message>
        <source>More than half of the readings of {} are clipped at the end of the sensor&apos;s range, so the channel is not used.</source>
        <translation>Mehr als die Hälfte der Messwerte von {} ist am Ende des Messbereichs abgeschnitten; der Kanal wird deshalb nicht verwendet.</translation>
    </message>
    <message>
        <source>The samples&apos; time stamps jitter by {:.2g} ms at steps of {:.2g} ms: no accelerations can be computed from such a motion.</source>
        <translation>Die Zeitstempel der Messwerte schwanken um {:.2g} ms bei Schritten von {:.2g} ms: Aus einer solchen Bewegung lassen sich keine Beschleunigungen gewinnen.</translation>
    </message>
    <message>
        <source>{} and {} more segments, {:.2g} s in total</source>
        <translation>{} und {} weitere Strecken, zusammen {:.2g} s</translation>
    </message>
    <message>
        <source>It is excluded; mark it as free to use it.</source>
        <translation>Was dort steht, wird ausgelassen; markieren Sie es als frei, um es zu verwenden.</translation>
    </message>
    <message>
        <source>The shape contradicts the measured motion by {:.0f} standard deviations, so it was not used: the numbers come from the motion alone.</source>
        <translation>Die Form widerspricht der gemessenen Bewegung um {:.0f} Standardabweichungen und wurde deshalb weggelassen: Die Zahlen kommen allein aus der Bewegung.</translation>
    </message>
    <message>
        <source>Times count from 0 at the stated rate, {:g} Hz.</source>
        <translation>Die Zeiten zählen ab 0 mit der genannten Rate, {:g} Hz.</translation>
    </message>
    <message>
        <source>The link /{} is broken.</source>
        <translation>Der Verweis /{} ist unterbrochen.</translation>
    </message>
    <message>
        <source>Copy the file that it refers to beside this one.</source>
        <translation>Kopieren Sie die Datei, die er nennt, neben diese.</translation>
    </message>
    <message>
        <source>{} missing in {} of {} samples and not used.</source>
        <translation>{} in {} von {} Werten nicht vorhanden und bleiben weg.</translation>
    </message>
    <message>
        <source>The time stamps of {} restart in the middle; the recorder&apos;s times are used for all.</source>
        <translation>Die Zeitstempel von {} beginnen mittendrin von vorn; für alle gelten die Zeiten des Aufzeichners.</translation>
    </message>
    <message>
        <source>the times of {} decrease from {:.4f} s to {:.4f} s at sample {}, overlapping earlier samples: two recordings, or two clocks.</source>
        <translation>die Zeiten von {} fallen von {:.4f} s auf {:.4f} s bei Wert {}, über schon Vorhandenes: zwei Aufnahmen oder zwei Uhren.</translation>
    </message>
    <message>
        <source>the offset of {} is {:g} s, more than the {:g} s (63 years) that clocks can differ by.</source>
        <translation>der Versatz von {} beträgt {:g} s, mehr als die {:g} s (63 Jahre), um die Uhren sich unterscheiden können.</translation>
    </message>
    <message>
        <source>Offsets are in seconds, even where the file counts in ms or ns.</source>
        <translation>Versätze sind in Sekunden, auch wenn die Datei in ms oder ns zählt.</translation>
    </message>
    <message>
        <source>&quot;rate_hz&quot; is not a rate above 0.</source>
        <translation>„rate_hz“ ist keine Rate über 0.</translation>
    </message>
    <message>
        <source>Save each quantity as a matrix of numbers with one row per sample.</source>
        <translation>Speichern Sie jede Größe als Matrix von Zahlen mit einer Zeile je Wert.</translation>
    </message>
    <message>
        <source>Save each quantity as an array of numbers with one row per sample.</source>
        <translation>Speichern Sie jede Größe als Feld von Zahlen mit einer Zeile je Wert.</translation>
    </message>
    <message>
        <source>The first row looks like data, not like names; judging by the numbers, the columns are taken to be {}.</source>
        <translation>Die erste Zeile sieht nach Daten aus, nicht nach Namen; nach den Zahlen werden die Spalten für {} gehalten.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; in column time is not a number of seconds.</source>
        <translation>„{}“ in Spalte time ist keine Zahl von Sekunden.</translation>
    </message>
    <message>
        <source>The tool&apos;s mount flexes (flexible mount)</source>
        <translation>Montage gibt nach (weiche Halterung)</translation>
    </message>
    <message>
        <source>From some point on there is a residual that rotates with the tool, like a weight.</source>
        <translation>Von einem Augenblick an gibt es eine Abweichung, die sich mit dem Werkzeug dreht, wie ein Gewicht.</translation>
    </message>
    <message>
        <source>Several wrenches are possible; {} was used, since the motion explains {:.0f} % of its force, and {:.0f} % of that of {}.</source>
        <translation>Mehrere Kräfte kommen in Frage; genommen wurde {}, denn die Bewegung erklärt {:.0f} % ihrer Kraft, und {:.0f} % der von {}.</translation>
    </message>
    <message>
        <source>Several wrenches are possible; {} was used, and it could also be {}.</source>
        <translation>Mehrere Kräfte kommen in Frage; genommen wurde {}, es könnte auch {} sein.</translation>
    </message>
    <message>
        <source>{} already exists and was not overwritten.</source>
        <translation>{} gibt es schon; die Datei wurde nicht ersetzt.</translation>
    </message>
    <message>
        <source>{} was deleted while it was being written.</source>
        <translation>{} wurde gelöscht, während die Datei geschrieben wurde.</translation>
    </message>
    <message>
        <source>The log repeats each wrench for {:.0f} ms; each was used once, with the motion at the time it arrived.</source>
        <translation>Das Protokoll wiederholt jeden Messwert des Sensors {:.0f} ms lang; jeder wurde einmal verwendet, mit der Bewegung des Augenblicks, in dem er kam.</translation>
    </message>
    <message>
        <source>judging by its name, it is not on the tool</source>
        <translation>sein Name sagt, dass er nicht am Werkzeug sitzt</translation>
    </message>
    <message>
        <source>it is on another clock</source>
        <translation>er hat eine andere Uhr</translation>
    </message>
    <message>
        <source>its times restart in the middle</source>
        <translation>seine Zeiten beginnen in der Mitte von vorn</translation>
    </message>
    <message>
        <source>it has too few samples</source>
        <translation>er hat kaum Werte</translation>
    </message>
    <message>
        <source>The accelerometer was not used: {}.</source>
        <translation>Der Beschleunigungssensor wurde beiseite gelassen: {}.</translation>
    </message>
    <message>
        <source>The accelerometer&apos;s times were shifted by {:.4f} s, where it matches the force best.</source>
        <translation>Die Zeiten des Beschleunigungssensors wurden um {:.4f} s verschoben; so folgt ihm die Kraft am besten.</translation>
    </message>
    <message>
        <source>Is it on the tool side of the sensor, and does it read specific force, gravity included?</source>
        <translation>Sitzt er auf der Werkzeugseite des Sensors, und misst er samt Schwerkraft?</translation>
    </message>
    <message>
        <source>The accelerometer differs from the motion by {:.2g} m/s2 rms, wherever it is mounted: the tool accelerated differently from what the joints or poses say.</source>
        <translation>Der Beschleunigungssensor weicht um {:.2g} m/s2 eff. von der Bewegung ab, wo immer er sitzt: das Werkzeug wurde anders beschleunigt, als Gelenke oder Posen sagen.</translation>
    </message>
    <message>
        <source>Check the direction of gravity, the clocks, and whether something between arm and tool is loose.</source>
        <translation>Prüfen Sie die Richtung der Schwerkraft, die Uhren, und ob zwischen Arm und Werkzeug etwas nachgibt.</translation>
    </message>
    <message>
        <source>The accelerometer lacks an axis and is ignored.</source>
        <translation>Dem Beschleunigungssensor fehlt eine Achse; er bleibt beiseite.</translation>
    </message>
    <message>
        <source>The gyroscope lacks an axis and is ignored.</source>
        <translation>Dem Drehratensensor fehlt eine Achse; er bleibt beiseite.</translation>
    </message>
    <message>
        <source>The accelerometer reads {:.3g} most of the time, neither 9.81 m/s2 nor 1 g, and is not used: gravity was removed from it, or it is not an accelerometer.</source>
        <translation>Der Beschleunigungssensor zeigt meist {:.3g}, weder 9.81 m/s2 noch 1 g, und bleibt beiseite: die Schwerkraft wurde herausgerechnet, oder er ist keiner.</translation>
    </message>
    <message>
        <source>The model fits: only sensor noise and a random walk of its zero remain.</source>
        <translation>Das Modell passt: Es bleiben nur das Rauschen des Sensors und sein Nullpunkt, der langsam wandert.</translation>
    </message>
    <message>
        <source>The model fits: only sensor noise remains.</source>
        <translation>Das Modell passt: Es bleibt nur das Rauschen des Sensors.</translation>
    </message>
    <message>
        <source>Guide the tool for ten seconds and tilt it in all directions without touching anything.</source>
        <translation>Führen Sie das Werkzeug zehn Sekunden lang und kippen Sie es nach allen Seiten, ohne etwas zu berühren.</translation>
    </message>
    <message>
        <source>PASS. With this payload subtracted, only sensor noise remains.</source>
        <translation>BESTANDEN. Zieht man diese Last ab, bleibt nur das Rauschen des Sensors.</translation>
    </message>
    <message>
        <source>The sensor position differs by {:.2f} mm between {} and {}.</source>
        <translation>Der Sensor sitzt um {:.2f} mm versetzt in {} und {}.</translation>
    </message>
    <message>
        <source>{} is not reliable, so neither are the object&apos;s numbers.</source>
        <translation>{} verdient wenig Vertrauen, und damit auch die Zahlen des Gegenstands.</translation>
    </message>
    <message>
        <source>Estimate it separately and look at its findings.</source>
        <translation>Schätzen Sie sie für sich und sehen Sie die Hinweise an.</translation>
    </message>
    <message>
        <source>Swap the two recordings, or check that both are of the same tool.</source>
        <translation>Vertauschen Sie die beiden Aufnahmen, oder prüfen Sie, ob beide vom selben Werkzeug sind.</translation>
    </message>
    <message>
        <source>{} is not a result of a diagnosis; make one with heft diagnose REC --json FILE.</source>
        <translation>{} ist kein Ergebnis einer Diagnose; machen Sie eines mit heft diagnose REC --json DATEI.</translation>
    </message>
    <message>
        <source>It is about what the file&apos;s numbers mean, not about the setup.</source>
        <translation>Es geht darum, was die Zahlen der Datei bedeuten, nicht um den Aufbau.</translation>
    </message>
    <message>
        <source>This recording determines the orientation of the sensor or the robot&apos;s base only to +- {:.1f} degrees. That alone may shift the centre of mass by {:.0f} mm.</source>
        <translation>Diese Aufnahme zeigt nur auf +- {:.1f} Grad, wie der Sensor oder der Sockel des Roboters gedreht ist. Allein das kann den Schwerpunkt um {:.0f} mm verschieben.</translation>
    </message>
    <message>
        <source>State the mount and gravity in the setup file, or record a motion that tilts and rotates the tool more.</source>
        <translation>Geben Sie Einbaulage und Schwerkraft in der Aufbaudatei an, oder nehmen Sie eine Bewegung auf, die das Werkzeug stärker neigt und dreht.</translation>
    </message>
    <message>
        <source>Computing detection limits</source>
        <translation>Nachweisgrenzen werden berechnet</translation>
    </message>
    <message>
        <source>The arm&apos;s bodies cannot be read, so motions are not checked against the arm itself: {}</source>
        <translation>Die Körper des Arms lassen sich nicht lesen; Bewegungen werden deshalb nicht gegen den Arm selbst geprüft: {}</translation>
    </message>
    <message>
        <source>No motion from this posture stays clear of everything: {} Move the arm to where there is more room.</source>
        <translation>Keine Bewegung aus dieser Stellung bleibt von allem frei: {} Bringen Sie den Arm dorthin, wo mehr Platz ist.</translation>
    </message>
    <message>
        <source>The taught path leaves no room for added sine motions, even where it is free: {}</source>
        <translation>Schon der gelehrte Weg lässt in seinen freien Teilen keinen Platz für Sinusbewegungen: {}</translation>
    </message>
    <message>
        <source>Not checked against each other, since they are just as close in the home posture: {}.</source>
        <translation>Nicht gegeneinander geprüft, da sie einander schon in der Grundstellung so nahe sind: {}.</translation>
    </message>
    <message>
        <source>There are no points to build a hull from.</source>
        <translation>Es gibt keinen Punkt, um den sich eine Hülle legen ließe.</translation>
    </message>
    <message>
        <source>{} is not an object.</source>
        <translation>{} ist kein Objekt.</translation>
    </message>
    <message>
        <source>{}: the normal vector is zero.</source>
        <translation>{}: Die Normale hat keine Richtung.</translation>
    </message>
    <message>
        <source>{}: the edges of a box must be above zero.</source>
        <translation>{}: Die Kanten eines Quaders sind größer als null.</translation>
    </message>
    <message>
        <source>{} is not a room: expected {{&quot;schema&quot;: &quot;heft.room/1&quot;, &quot;obstacles&quot;: [...]}}.</source>
        <translation>{} ist kein Raum: erwartet wird {{&quot;schema&quot;: &quot;heft.room/1&quot;, &quot;obstacles&quot;: [...]}}.</translation>
    </message>
    <message>
        <source>it is pressed with less than {:.0f} N</source>
        <translation>es drückt mit weniger als {:.0f} N</translation>
    </message>
    <message>
        <source>the direction of the force varies by {:.0f} degrees</source>
        <translation>die Richtung der Kraft schwankt um {:.0f} Grad</translation>
    </message>
    <message>
        <source>{}: nothing was picked up or put down in it. Give two recordings instead, one with the object and one without.</source>
        <translation>{}: Darin wurde nichts aufgenommen oder abgelegt. Geben Sie stattdessen zwei Aufnahmen an, eine mit dem Gegenstand und eine ohne.</translation>
    </message>
    <message>
        <source>From another tool: by itself it gives {:.3f} kg, the others give {:.3f} kg.</source>
        <translation>Von einem anderen Werkzeug: Für sich ergibt sie {:.3f} kg, die anderen ergeben {:.3f} kg.</translation>
    </message>
    <message>
        <source>{} rows have no {} and were left out.</source>
        <translation>{} Zeilen haben kein {} und wurden beiseitegelassen.</translation>
    </message>
    <message>
        <source>The accelerometer reports gravity instead of specific force (at rest it points down); its signs were inverted.</source>
        <translation>Der Beschleunigungssensor meldet die Schwerkraft anstelle dessen, was er spürt (in Ruhe zeigt er nach unten); seine Vorzeichen wurden umgekehrt.</translation>
    </message>
    <message>
        <source>{} This is not attributed to the setup: Heft aligned the two clocks from the data, to within {:.1f} ms.</source>
        <translation>{} Das wird nicht dem Aufbau zugeschrieben: Heft hat die beiden Uhren anhand der Daten zusammengebracht, auf {:.1f} ms genau.</translation>
    </message>
    <message>
        <source>judging by its name, it does not move</source>
        <translation>ihrem Namen nach bewegt sie sich nicht</translation>
    </message>
    <message>
        <source>libfranka&apos;s end-effector pose, a matrix by columns</source>
        <translation>Pose des Endeffektors nach libfranka, eine Matrix nach Spalten</translation>
    </message>
    <message>
        <source>{} is not a passport: its &quot;schema&quot; should be &quot;{}&quot;.</source>
        <translation>{} ist kein Pass: „schema“ sollte „{}“ sein.</translation>
    </message>
    <message>
        <source>{}: mass, centre of mass or inertia is missing or holds something that is not a number.</source>
        <translation>{}: Masse, Schwerpunkt oder Trägheit fehlt oder enthält etwas, das keine Zahl ist.</translation>
    </message>
    <message>
        <source>{} is not a lesson: its &quot;schema&quot; should be &quot;{}&quot;.</source>
        <translation>{} ist keine Lektion: „schema“ sollte „{}“ sein.</translation>
    </message>
    <message>
        <source>Something else affects the readings, too. The reference point of the torque, and the centre of mass with it, may be off by as much as {:.0f} mm.</source>
        <translation>In den Messwerten steckt noch etwas anderes. Der Bezugspunkt des Drehmoments und mit ihm der Schwerpunkt können um bis zu {:.0f} mm falsch sein.</translation>
    </message>
    <message>
        <source>This recording determines the reference point of the torque, and with it the centre of mass, only to +- {:.0f} mm.</source>
        <translation>Diese Aufnahme zeigt den Bezugspunkt des Drehmoments nur auf +- {:.0f} mm genau, und den Schwerpunkt ebenso.</translation>
    </message>
    <message>
        <source>Measure from the flange to the sensor&apos;s origin and compare with the setup file. If that is right, the torque refers to another point: state wrench_point.</source>
        <translation>Messen Sie vom Flansch zum Ursprung des Sensors und vergleichen Sie mit der Aufbaudatei. Stimmt das Maß, bezieht sich das Drehmoment auf einen anderen Punkt: Geben Sie wrench_point an.</translation>
    </message>
    <message>
        <source>Joint {} would need {:.1f} N m of the allowed {:.1f} N m, {:.1f} s into the motion.</source>
        <translation>Gelenk {} bräuchte {:.1f} von {:.1f} N m, die es aufbringen darf, {:.1f} s nach Beginn der Bewegung.</translation>
    </message>
    <message>
        <source>{} is not a result of an estimate; make one with heft estimate REC --json FILE.</source>
        <translation>{} ist kein Ergebnis einer Schätzung; erzeugen Sie eines mit heft estimate REC --json DATEI.</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>The numbers are corrected for it.</source>
        <translation>Sie ist aus den Zahlen herausgerechnet.</translation>
    </message>
    <message>
        <source>The numbers are not corrected for it.</source>
        <translation>Sie ist nicht aus den Zahlen herausgerechnet.</translation>
    </message>
    <message>
        <source>Not detectable in this recording: {}.</source>
        <translation>In dieser Aufnahme nicht erkennbar: {}.</translation>
    </message>
    <message>
        <source>These numbers are not reliable; see the result’s warnings.</source>
        <translation>Diese Zahlen sind nicht verlässlich; siehe die Warnungen des Ergebnisses.</translation>
    </message>
    <message>
        <source>Residual in free motion: {} N and {}; sensor noise: {} N and {}.</source>
        <translation>Rest in freier Bewegung: {} N und {}; Rauschen des Sensors: {} N und {}.</translation>
    </message>
    <message>
        <source>An error of {} or {} would have been detected.</source>
        <translation>Ein Fehler von {} oder {} wäre aufgefallen.</translation>
    </message>
    <message>
        <source>PASS: with these numbers subtracted, only sensor noise remains.</source>
        <translation>BESTANDEN: Ohne diese Last bleibt nur das Rauschen des Sensors.</translation>
    </message>
    <message>
        <source>Visit poses with very different angles of the other joints, elbow high and low. No motion distinguishes a wrong zero of the last joint from a sensor rotated about its axis: check the robot.</source>
        <translation>Lagen aufsuchen, in denen die anderen Gelenke ganz anders stehen, Ellbogen hoch und tief. Eine falsche Nullstellung des letzten Gelenks unterscheidet keine Bewegung von einem um seine Achse verdrehten Sensor: Sehen Sie am Aufbau nach.</translation>
    </message>
    <message>
        <source>Turn the last joint by half a turn and hold, then tilt the tool. No motion distinguishes a sensor rotated about the last joint&apos;s axis from a wrong zero of that joint: check the robot.</source>
        <translation>Das letzte Gelenk um eine halbe Drehung drehen und halten, dann das Werkzeug kippen. Einen um die Achse des letzten Gelenks verdrehten Sensor unterscheidet keine Bewegung von einer falschen Nullstellung dieses Gelenks: Sehen Sie am Aufbau nach.</translation>
    </message>
    <message>
        <source>The tool changed at {:.1f} s: {:.2f} kg became {:.2f} kg. The estimate restarts with what came after.</source>
        <translation>Das Werkzeug wechselte bei {:.1f} s: Aus {:.2f} kg wurden {:.2f} kg. Die Schätzung beginnt mit dem, was danach kam, von vorn.</translation>
    </message>
    <message>
        <source>The time stamps jitter by {:.2g} ms. At even steps of {:.4g} ms the motion is much smoother, so these were used.</source>
        <translation>Die Zeitstempel streuen um {:.2g} ms. In gleichen Schritten von {:.4g} ms ist die Bewegung viel glatter; diese wurden verwendet.</translation>
    </message>
    <message>
        <source>{} has {} poses and {} has {} wrenches, without times in common.</source>
        <translation>{} enthält {} Posen und {} enthält {} Kraft-/Momentwerte, ohne gemeinsame Zeiten.</translation>
    </message>
    <message>
        <source>Standing poses in two files are joined row by row: write as many rows in both.</source>
        <translation>Standposen in zwei Dateien werden Zeile für Zeile verbunden: Schreiben Sie in beide gleich viele Zeilen.</translation>
    </message>
    <message>
        <source>{} and {} were joined row by row.</source>
        <translation>{} und {} wurden Zeile für Zeile verbunden.</translation>
    </message>
    <message>
        <source>There are {} joints but no robot is named, so the pose is read instead and taken for the sensor&apos;s.</source>
        <translation>Es gibt {} Gelenke, aber es ist kein Roboter genannt; daher wird stattdessen die Pose gelesen und als die des Sensors genommen.</translation>
    </message>
    <message>
        <source>pose of an ABB, the quaternion&apos;s real part first</source>
        <translation>Pose eines ABB, Realteil der Quaternion zuerst</translation>
    </message>
    <message>
        <source>the time increases by exactly 1 from row to row, like row numbers.</source>
        <translation>die Zeit steigt von Zeile zu Zeile um genau 1, wie Zeilennummern.</translation>
    </message>
    <message>
        <source>Or state its unit in a map file: {}.</source>
        <translation>Oder geben Sie ihre Einheit in einer Zuordnungsdatei an: {}.</translation>
    </message>
    <message>
        <source>Joints of two arms are there; {} was used, and it could also be {}.</source>
        <translation>Es gibt Gelenke zweier Arme; {} wurde verwendet, es könnte auch {} sein.</translation>
    </message>
    <message>
        <source>Choose the joints one by one, for instance --use q1={}.</source>
        <translation>Wählen Sie die Gelenke einzeln, zum Beispiel mit --use q1={}.</translation>
    </message>
    <message>
        <source>table</source>
        <translation>Tisch</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation>Decke</translation>
    </message>
    <message>
        <source>None were found.</source>
        <translation>Es wurden keine gefunden.</translation>
    </message>
    <message>
        <source>The sensor mounting differs, so only the mass is compared.</source>
        <translation>Der Sensor ist anders angebaut, daher wird nur die Masse verglichen.</translation>
    </message>
    <message>
        <source>{} contains no contact that defines a plane. Press the tool against each wall or table and hold it for a second, with free motion between.</source>
        <translation>{} enthält keinen Kontakt, der eine Ebene festlegt. Drücken Sie das Werkzeug gegen jede Wand und jeden Tisch und halten Sie es eine Sekunde, mit freier Bewegung dazwischen.</translation>
    </message>
    <message>
        <source>The tool has changed: the difference exceeds the measurement uncertainty.</source>
        <translation>Das Werkzeug hat sich verändert: Der Unterschied ist größer als die Messunsicherheit.</translation>
    </message>
    <message>
        <source>No change beyond the measurement uncertainty.</source>
        <translation>Keine Veränderung über die Messunsicherheit hinaus.</translation>
    </message>
    <message>
        <source>this looks like a pickle, which only the Python program that wrote it can read.</source>
        <translation>das sieht wie eine Pickle-Datei aus, die nur das Python-Programm lesen kann, das sie geschrieben hat.</translation>
    </message>
    <message>
        <source>Save the arrays from there by numpy.savez, or as CSV.</source>
        <translation>Speichern Sie die Felder von dort mit numpy.savez oder als CSV.</translation>
    </message>
    <message>
        <source>this is what &apos;ros2 topic echo&apos; prints, as YAML.</source>
        <translation>das ist die Ausgabe von &apos;ros2 topic echo&apos; als YAML.</translation>
    </message>
    <message>
        <source>Record the topics of motion and wrench together by &apos;ros2 bag record&apos;, or echo each with --csv and join the two by --join.</source>
        <translation>Zeichnen Sie die Topics von Bewegung und Kraft zusammen mit &apos;ros2 bag record&apos; auf, oder geben Sie beide mit --csv aus und fügen Sie sie mit --join zusammen.</translation>
    </message>
    <message>
        <source>{} cells hold no number, for instance &quot;{}&quot; under &quot;{}&quot;; their rows were left out of that column.</source>
        <translation>{} Zellen enthalten keine Zahl, zum Beispiel &quot;{}&quot; unter &quot;{}&quot;; ihre Zeilen fehlen in dieser Spalte.</translation>
    </message>
    <message>
        <source>Correct them, or export the table again.</source>
        <translation>Berichtigen Sie sie, oder exportieren Sie die Tabelle noch einmal.</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>zweifelhaft</translation>
    </message>
    <message>
        <source>The object seems to weigh {:.3f} kg.</source>
        <translation>Das Objekt scheint {:.3f} kg zu wiegen.</translation>
    </message>
    <message>
        <source>The estimated centre of mass is {:.0f} mm off the known one, far outside its interval.</source>
        <translation>Der bestimmte Schwerpunkt weicht um {:.0f} mm vom bekannten ab, weit außerhalb seines Bereichs.</translation>
    </message>
    <message>
        <source>The estimated inertia is {:.0f} % off the known one, far outside its interval.</source>
        <translation>Die bestimmte Trägheit weicht um {:.0f} % von der bekannten ab, weit außerhalb ihres Bereichs.</translation>
    </message>
    <message>
        <source>Comparing with the conventions as stated</source>
        <translation>Vergleich mit den Konventionen, wie sie angegeben sind</translation>
    </message>
    <message>
        <source>Variable {} of the file is damaged; it and those after it were not read.</source>
        <translation>Variable {} der Datei ist beschädigt; sie und die danach wurden nicht gelesen.</translation>
    </message>
    <message>
        <source>All causes were searched for from {:.0f} to {:.0f} s; the rest of this long recording was checked against the result, in steps of {:.1f} s.</source>
        <translation>Alle Ursachen wurden von {:.0f} bis {:.0f} s gesucht; der Rest dieser langen Aufzeichnung wurde mit dem Ergebnis verglichen, in Schritten von {:.1f} s.</translation>
    </message>
    <message>
        <source>A brief disturbance elsewhere may go unnoticed: diagnose a recording of at most {:.0f} s of it.</source>
        <translation>Eine kurze Störung an anderer Stelle kann unbemerkt bleiben: Prüfen Sie davon eine Aufzeichnung von höchstens {:.0f} s.</translation>
    </message>
    <message>
        <source>the file is damaged: the library that reads files of this kind crashed on it.</source>
        <translation>die Datei ist beschädigt: Die Bibliothek, die solche Dateien liest, ist daran abgestürzt.</translation>
    </message>
    <message>
        <source>Copy it again from where it was recorded, or save it again there.</source>
        <translation>Kopieren Sie sie noch einmal von dort, wo sie aufgezeichnet wurde, oder speichern Sie sie dort neu.</translation>
    </message>
    <message>
        <source>Not used, since they hold one value nearly all the time and show nothing of the payload: {}.</source>
        <translation>Nicht verwendet, da sie fast durchgehend einen einzigen Wert haben und nichts von der Nutzlast zeigen: {}.</translation>
    </message>
    <message>
        <source>{} of the rows repeat the {} of the row before: its steps are coarser than its noise.</source>
        <translation>{} der Zeilen wiederholen {} der Zeile davor: Die Stufen sind gröber als das Rauschen.</translation>
    </message>
    <message>
        <source>The readings are those from {:.2f} s on once more: they were logged twice.</source>
        <translation>Die Messwerte sind noch einmal die ab {:.2f} s: Sie wurden doppelt aufgezeichnet.</translation>
    </message>
    <message>
        <source>{} rows are zero in every channel of the wrench, as where a source has no reading; they were replaced by their neighbours.</source>
        <translation>{} Zeilen sind in allen Kanälen von Kraft und Drehmoment null, wie wenn eine Quelle keinen Messwert hat; sie wurden durch ihre Nachbarn ersetzt.</translation>
    </message>
    <message>
        <source>The database unpacks to more than {} MB; the rest was not read.</source>
        <translation>Die Datenbank entpackt sich auf mehr als {} MB; der Rest wurde nicht gelesen.</translation>
    </message>
    <message>
        <source>{} and {} more segment, {:.2g} s in total</source>
        <translation>{} und {} weitere Strecke, zusammen {:.2g} s</translation>
    </message>
    <message>
        <source>It is used, since it is marked as free.</source>
        <translation>Die Strecke wird verwendet, da sie als frei markiert ist.</translation>
    </message>
    <message>
        <source>The contact from {} gives no plane: {}.</source>
        <translation>Der Kontakt von {} ergibt keine Ebene: {}.</translation>
    </message>
    <message>
        <source>One chunk of the file is damaged; what could be unpacked was read.</source>
        <translation>Ein Block der Datei ist beschädigt; gelesen wurde, was sich auspacken ließ.</translation>
    </message>
    <message>
        <source>One chunk of the bag is damaged; what could be unpacked was read.</source>
        <translation>Ein Block des Bags ist beschädigt; was sich entpacken ließ, wurde gelesen.</translation>
    </message>
    <message>
        <source>The data had one gap.</source>
        <translation>Die Daten hatten eine Lücke.</translation>
    </message>
    <message>
        <source>One sample was not usable: not finite, without motion, or with a time that does not increase.</source>
        <translation>Eine Messung war nicht brauchbar: nicht endlich, ohne Bewegung, oder mit einer Zeit, die nicht steigt.</translation>
    </message>
    <message>
        <source>One quaternion is not of length 1, by {:.2g}; it was normalised.</source>
        <translation>Ein Quaternion hat nicht die Länge 1, um {:.2g} daneben; es wurde normiert.</translation>
    </message>
    <message>
        <source>Samples were lost there; gaps of more than {:.0f} ms are left out.</source>
        <translation>Dort gingen Messwerte verloren; Lücken von mehr als {:.0f} ms werden ausgelassen.</translation>
    </message>
    <message>
        <source>{} is no object</source>
        <translation>{} ist kein Objekt</translation>
    </message>
    <message>
        <source>{} is no list</source>
        <translation>{} ist keine Liste</translation>
    </message>
    <message>
        <source>{} is no text</source>
        <translation>{} ist kein Text</translation>
    </message>
    <message>
        <source>{} is missing</source>
        <translation>{} fehlt</translation>
    </message>
    <message>
        <source>{}: {}; make it again with heft diagnose REC --json FILE.</source>
        <translation>{}: {}; machen Sie die Datei neu mit heft diagnose REC --json DATEI.</translation>
    </message>
    <message>
        <source>the file changed while it was read.</source>
        <translation>die Datei wurde während des Lesens verändert.</translation>
    </message>
    <message>
        <source>Read it again once it is complete.</source>
        <translation>Lesen Sie sie noch einmal, sobald sie vollständig ist.</translation>
    </message>
    <message>
        <source>The temporary file with the samples ends too early.</source>
        <translation>Die temporäre Datei mit den Messwerten endet zu früh.</translation>
    </message>
</context>
<context>
    <name>heft::Autosave</name>
    <message>
        <source>%1 cannot be locked.</source>
        <translation>%1 kann nicht gesperrt werden.</translation>
    </message>
</context>
<context>
    <name>heft::CarriedObjects</name>
    <message>
        <source>Open the recording with the object first.</source>
        <translation>Öffnen Sie zuerst die Aufnahme mit dem Gegenstand.</translation>
    </message>
    <message>
        <source>This is the recording with the object itself. Choose one without it.</source>
        <translation>Das ist die Aufnahme mit dem Gegenstand selbst: Wählen Sie eine ohne ihn.</translation>
    </message>
    <message>
        <source>Estimating what is carried</source>
        <translation>Was getragen wird, wird gesucht</translation>
    </message>
</context>
<context>
    <name>heft::ChannelLanes</name>
    <message>
        <source>Further channels over time</source>
        <translation>Weitere Kanäle über der Zeit</translation>
    </message>
</context>
<context>
    <name>heft::ConventionsForm</name>
    <message>
        <source>Conventions of the numbers</source>
        <translation>Konventionen der Zahlen</translation>
    </message>
    <message>
        <source>Force and torque</source>
        <translation>Kraft und Moment</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Joints and poses</source>
        <translation>Gelenke und Posen</translation>
    </message>
    <message>
        <source>another</source>
        <translation>andere</translation>
    </message>
    <message>
        <source>Axes, signs, units and orders that differ from the usual ones</source>
        <translation>Achsen, Vorzeichen, Einheiten und Reihenfolgen, wo sie nicht die üblichen sind</translation>
    </message>
    <message>
        <source>That point from the sensor’s origin along its %1</source>
        <translation>Dieser Punkt vom Ursprung des Sensors aus entlang seines %1</translation>
    </message>
    <message>
        <source>Point x, y, z</source>
        <translation>Dieser Punkt x, y, z</translation>
    </message>
    <message>
        <source>%1: how many %2 one unit is</source>
        <translation>%1: wie viele %2 eine davon sind</translation>
    </message>
</context>
<context>
    <name>heft::DecidingMotion</name>
    <message>
        <source>Move like this</source>
        <translation>So bewegen</translation>
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
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>RMS residual</source>
        <translation>Rest (eff.)</translation>
    </message>
    <message>
        <source>1/Δt %1 Hz</source>
        <translation>1/Δt %1 Hz</translation>
    </message>
</context>
<context>
    <name>heft::DifferencePane</name>
    <message>
        <source>The difference</source>
        <translation>Die Abweichung</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Against</source>
        <translation>Gegen</translation>
    </message>
    <message>
        <source>with the causes</source>
        <translation>mit den Ursachen</translation>
    </message>
    <message>
        <source>without</source>
        <translation>ohne</translation>
    </message>
    <message>
        <source>Frequency [Hz]</source>
        <translation>Frequenz [Hz]</translation>
    </message>
    <message>
        <source>With the causes: %1 [%2]</source>
        <translation>Mit den Ursachen: %1 [%2]</translation>
    </message>
    <message>
        <source>Without: %1 [%2]</source>
        <translation>Ohne: %1 [%2]</translation>
    </message>
    <message>
        <source>Nothing to compare with.</source>
        <translation>Nichts zum Vergleichen.</translation>
    </message>
    <message>
        <source>Grey: the level of the sensor’s fast noise. Low-frequency noise can be several times higher; peaks far above the band are not noise.</source>
        <translation>Grau: die Höhe des schnellen Sensorrauschens. Langsames Rauschen kann einige Male höher liegen; was weit darüber ragt, ist keines.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Zusammenhang</translation>
    </message>
    <message>
        <source>Measured and simulated over time</source>
        <translation>Gemessen und simuliert über der Zeit</translation>
    </message>
    <message>
        <source>Which causes</source>
        <translation>Welche Ursachen</translation>
    </message>
    <message>
        <source>Show the whole recording</source>
        <translation>Die ganze Aufnahme zeigen</translation>
    </message>
    <message>
        <source>Copy this picture</source>
        <translation>Dieses Bild kopieren</translation>
    </message>
    <message>
        <source>Save this picture</source>
        <translation>Dieses Bild speichern</translation>
    </message>
    <message>
        <source>Show force and torque instead</source>
        <translation>Stattdessen Kraft und Moment zeigen</translation>
    </message>
    <message>
        <source>all causes</source>
        <translation>alle Ursachen</translation>
    </message>
    <message>
        <source>rate of change of the load</source>
        <translation>Änderungsrate der Last</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>simulated as stated</source>
        <translation>simuliert wie angegeben</translation>
    </message>
    <message>
        <source>with the cause corrected</source>
        <translation>mit der Ursache berichtigt</translation>
    </message>
    <message>
        <source>· grey: the sensor’s noise, ±2 σ</source>
        <translation>· grau: Rauschen des Sensors, ±2 σ</translation>
    </message>
    <message>
        <source>A sloped or curved cloud means that the difference depends on this quantity. Both pictures have one scale; click on a dot to go to its time.</source>
        <translation>Eine schräge oder krumme Wolke heißt, dass die Abweichung von dieser Größe abhängt. Beide Bilder haben einen Maßstab; ein Klick auf einen Punkt führt zu seiner Zeit.</translation>
    </message>
    <message>
        <source>Picture of this</source>
        <translation>Bild davon</translation>
    </message>
    <message>
        <source>No segment is long enough for a spectrum.</source>
        <translation>Kein Abschnitt ist lang genug, um Frequenzen zu zeigen.</translation>
    </message>
    <message>
        <source>Residual by frequency</source>
        <translation>Rest nach Frequenz</translation>
    </message>
    <message>
        <source>Residual against the robot’s motion</source>
        <translation>Rest gegen die Bewegung des Roboters</translation>
    </message>
    <message>
        <source>Maximise the plots, or restore them (F11)</source>
        <translation>Kurven maximieren oder zurückholen (F11)</translation>
    </message>
    <message>
        <source>Grey: sensor noise as used by the verdict, including slow noise.</source>
        <translation>Grau: was das Urteil für Rauschen des Sensors hält, auch langsames.</translation>
    </message>
    <message>
        <source>Residual torque [%1/√Hz]</source>
        <translation>Rest, Moment [%1/√Hz]</translation>
    </message>
    <message>
        <source>Residual force [%1/√Hz]</source>
        <translation>Rest, Kraft [%1/√Hz]</translation>
    </message>
    <message>
        <source>clean twin, and the fault alone</source>
        <translation>fehlerfreier Zwilling, und der Fehler allein</translation>
    </message>
</context>
<context>
    <name>heft::DifferenceTraces</name>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>without</source>
        <translation>ohne</translation>
    </message>
    <message>
        <source>with the causes</source>
        <translation>mit den Ursachen</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Nothing to compare yet.</source>
        <translation>Noch nichts zu vergleichen.</translation>
    </message>
    <message>
        <source>pose</source>
        <translation>Stellung</translation>
    </message>
    <message>
        <source>Measured and simulated, without and with the causes, and the residual</source>
        <translation>Gemessen und simuliert, ohne und mit den Ursachen, und der Rest</translation>
    </message>
    <message>
        <source>residual without</source>
        <translation>Rest ohne</translation>
    </message>
    <message>
        <source>residual with</source>
        <translation>Rest mit</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>clean twin</source>
        <translation>fehlerfreier Zwilling</translation>
    </message>
    <message>
        <source>the fault alone</source>
        <translation>der Fehler allein</translation>
    </message>
</context>
<context>
    <name>heft::DimensionEditor</name>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>A length in mm, or with its unit: 64, 6.4 cm. Enter applies, Esc cancels.</source>
        <translation>Eine Länge in mm oder mit ihrer Einheit: 64, 6,4 cm. Die Eingabetaste übernimmt sie, Esc lässt sie, wie sie war.</translation>
    </message>
</context>
<context>
    <name>heft::EntryCard</name>
    <message>
        <source>Phantom force</source>
        <translation>Scheinkraft</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Change it …</source>
        <translation>Ändern …</translation>
    </message>
    <message>
        <source>Enter it …</source>
        <translation>Eingeben …</translation>
    </message>
    <message>
        <source>From a payload file …</source>
        <translation>Aus einer Lastdatei …</translation>
    </message>
    <message>
        <source>Heft compares it along the motion …</source>
        <translation>Heft vergleicht ihn entlang der Bewegung …</translation>
    </message>
    <message>
        <source>Set as in the recording (%1).</source>
        <translation>Eingestellt, wie es die Aufnahme sagt (%1).</translation>
    </message>
    <message>
        <source>Set as you typed it.</source>
        <translation>Eingestellt, wie Sie es eingaben.</translation>
    </message>
    <message>
        <source>Set as in %1.</source>
        <translation>Eingestellt wie in %1.</translation>
    </message>
    <message>
        <source>the controller’s entry</source>
        <translation>Eintrag der Steuerung</translation>
    </message>
    <message>
        <source>What the controller is set to</source>
        <translation>Was in der Steuerung steht</translation>
    </message>
    <message>
        <source>Payload files (*.json);;All files (*)</source>
        <translation>Lastdateien (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Enter the payload that the controller is set to. Heft then shows the phantom forces it would see, and their effect.</source>
        <translation>Geben Sie die Last ein, die in der Steuerung steht. Heft zeigt dann die Scheinkräfte, die sie sähe, und was sie bewirken.</translation>
    </message>
    <message>
        <source>The arrow on the tool shows the force at the current time.</source>
        <translation>Der Pfeil am Werkzeug zeigt die Kraft im gezeigten Augenblick.</translation>
    </message>
    <message>
        <source>What does the controller’s current entry cost?</source>
        <translation>Was kostet der aktuelle Eintrag?</translation>
    </message>
</context>
<context>
    <name>heft::EntryCosts</name>
    <message>
        <source>the controller’s entry</source>
        <translation>Eintrag der Steuerung</translation>
    </message>
    <message>
        <source>Computing what the entry costs</source>
        <translation>Rechnet aus, was der Eintrag kostet</translation>
    </message>
</context>
<context>
    <name>heft::EntryDialog</name>
    <message>
        <source>What is the controller set to?</source>
        <translation>Was steht in der Steuerung?</translation>
    </message>
    <message>
        <source>What it reacts to</source>
        <translation>Worauf sie reagiert</translation>
    </message>
    <message>
        <source>Collision force [N]</source>
        <translation>Kollisionskraft [N]</translation>
    </message>
    <message>
        <source>Collision torque [N m]</source>
        <translation>Kollisionsmoment [N m]</translation>
    </message>
    <message>
        <source>Stiffness of the arm [N/m]</source>
        <translation>Steifigkeit des Arms [N/m]</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>The weight is missing.</source>
        <translation>Das Gewicht fehlt.</translation>
    </message>
    <message>
        <source>As entered in the controller, with everything beyond the flange. A weight of 0 means that nothing was entered.</source>
        <translation>So, wie es in der Steuerung steht, mit allem jenseits des Flanschs. Ein Gewicht von 0 heißt, dass nichts eingegeben wurde.</translation>
    </message>
    <message>
        <source>Centre from the flange, inertia about the centre of mass, along the flange’s axes. Empty fields use the estimate.</source>
        <translation>Schwerpunkt vom Flansch aus, Trägheit um den Schwerpunkt, entlang der Achsen des Flanschs. Was Sie leer lassen, gilt wie geschätzt.</translation>
    </message>
    <message>
        <source>Defaults as in libfranka’s examples: 10 N, 10 N m, 3000 N/m. Use the values of your program.</source>
        <translation>Zunächst wie in den Beispielen von libfranka: 10 N, 10 N m, 3000 N/m. Es zählen die Werte Ihres Programms.</translation>
    </message>
    <message>
        <source>%1 must be a number above zero.</source>
        <translation>%1 sollte eine Zahl über null sein.</translation>
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
        <source>Don’t enter it as both, or its weight is counted twice.</source>
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
        <source>Don’t forget the sensor’s own weight: tick it above unless the controller already includes it, or tick “Nothing else”.</source>
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
        <source>%1 already exists and was not overwritten.</source>
        <translation>%1 gibt es schon und wurde nicht ersetzt.</translation>
    </message>
    <message>
        <source>The file was copied to the clipboard.</source>
        <translation>Die Datei liegt in der Zwischenablage.</translation>
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
        <source>Answer the question above before saving.</source>
        <translation>Sagen Sie oben, ob das das eigene Werkzeug des Roboters ist oder etwas, das er aufgenommen hat; dann lässt es sich speichern.</translation>
    </message>
    <message>
        <source>one question left</source>
        <translation>eine Antwort fehlt</translation>
    </message>
    <message>
        <source>Run reality check</source>
        <translation>Nachsehen, was nicht stimmt</translation>
    </message>
    <message>
        <source>Heft Studio</source>
        <translation>Heft Studio</translation>
    </message>
    <message>
        <source>%1

A robot with a wrong load setting drifts when it is guided, stops without a reason, or does not stop when it should.</source>
        <translation>%1

Ein Roboter mit falsch angegebener Last driftet beim Führen, hält grundlos an oder hält nicht an, wenn er sollte.</translation>
    </message>
    <message>
        <source>Do not write</source>
        <translation>Nicht schreiben</translation>
    </message>
    <message>
        <source>see the warnings</source>
        <translation>siehe Warnungen</translation>
    </message>
    <message>
        <source>Read the warnings above first.</source>
        <translation>Lesen Sie erst die Warnungen oben.</translation>
    </message>
    <message>
        <source>The reality check found a cause that is not applied: %1</source>
        <translation>Die Realitätsprüfung fand eine Ursache, die nicht angewendet ist: %1</translation>
    </message>
    <message>
        <source>With it the result changes: %1.</source>
        <translation>Mit ihr ändert sich das Ergebnis: %1.</translation>
    </message>
    <message>
        <source>Tool centre point</source>
        <translation>Werkzeugmittelpunkt</translation>
    </message>
    <message>
        <source>tool centre point</source>
        <translation>Werkzeugmittelpunkt</translation>
    </message>
    <message>
        <source>Back to the reality check</source>
        <translation>Zurück zur Realitätsprüfung</translation>
    </message>
    <message>
        <source>Back to the result</source>
        <translation>Zurück zum Ergebnis</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Which controller is this for?</source>
        <translation>Für welche Steuerung?</translation>
    </message>
    <message>
        <source>Estimate a result first.</source>
        <translation>Zuerst ein Ergebnis schätzen.</translation>
    </message>
    <message>
        <source>An existing file is never overwritten without asking</source>
        <translation>Eine vorhandene Datei wird nie ohne Rückfrage ersetzt</translation>
    </message>
    <message>
        <source>Don’t forget the sensor’s own weight: add it under “Something else …” unless the controller already includes it, or tick “Nothing else”.</source>
        <translation>Der Sensor selbst wiegt auch etwas: Fügen Sie ihn unter „Etwas anderes …“ hinzu, wenn die Steuerung ihn noch nicht kennt, oder wählen Sie „Nichts weiter“.</translation>
    </message>
    <message>
        <source>This result is not reliable, so no file is written.</source>
        <translation>Dieses Ergebnis ist nicht verlässlich, daher wird keine Datei geschrieben.</translation>
    </message>
    <message>
        <source>Write it anyway …</source>
        <translation>Trotzdem schreiben …</translation>
    </message>
    <message>
        <source>Write a payload that the recording does not support?</source>
        <translation>Eine Last schreiben, die nichts in der Aufnahme stützt?</translation>
    </message>
    <message>
        <source>Write it; I know that these numbers are wrong</source>
        <translation>Ich weiß, dass diese Zahlen falsch sind; schreiben</translation>
    </message>
    <message>
        <source>Save anyway</source>
        <translation>Trotzdem speichern</translation>
    </message>
    <message>
        <source>from the flange, its axes, in mm</source>
        <translation>vom Flansch, in dessen Achsen, in mm</translation>
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
        <source>saved</source>
        <translation>gespeichert</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>noch nicht geschrieben</translation>
    </message>
    <message>
        <source>Not determined by the motion</source>
        <translation>Nicht aus der Bewegung bekannt</translation>
    </message>
    <message>
        <source>The file, before it is written</source>
        <translation>Die Datei, bevor sie geschrieben wird</translation>
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
        <source>Heft sessions (*.heft)</source>
        <translation>Heft-Sitzungen (*.heft)</translation>
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
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Open a recording first: robot and sensor belong to it.</source>
        <translation>Öffnen Sie zuerst eine Aufnahme: Roboter und Sensor gehören zu ihr.</translation>
    </message>
    <message>
        <source>Open a recording first: its columns belong to it.</source>
        <translation>Öffnen Sie zuerst eine Aufnahme: Die Spalten gehören zu ihr.</translation>
    </message>
    <message>
        <source>Save session</source>
        <translation>Sitzung speichern</translation>
    </message>
    <message>
        <source>%1 already exists and was not overwritten. Choose it in the dialog to overwrite it.</source>
        <translation>%1 gibt es schon und wurde nicht ersetzt: Wählen Sie die Datei im Dialog aus, um sie zu ersetzen.</translation>
    </message>
    <message>
        <source>Save changes to this session?</source>
        <translation>Änderungen an dieser Sitzung speichern?</translation>
    </message>
    <message>
        <source>Unsaved marks, shape and settings will be lost.</source>
        <translation>Nicht gespeicherte Marken, Form und Einstellungen gehen verloren.</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>Keine Dateien</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
</context>
<context>
    <name>heft::FlangeGuide</name>
    <message>
        <source>Drag to move the tool</source>
        <translation>Ziehen bewegt das Werkzeug</translation>
    </message>
    <message>
        <source>Drag along the ring to rotate the tool</source>
        <translation>Am Ring ziehen, um das Werkzeug zu drehen</translation>
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
        <source>Centre from the sensor’s origin, inertia about the centre of mass, along the sensor’s axes. Products as in the inertia matrix.</source>
        <translation>Schwerpunkt vom Ursprung des Sensors, Trägheit um den Schwerpunkt, entlang der Sensorachsen. Deviationsmomente wie in der Trägheitsmatrix.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>What do you already know?</source>
        <translation>Was wissen Sie schon?</translation>
    </message>
    <message>
        <source>From a scale or from CAD. Used for comparison only; leave unknown fields empty.</source>
        <translation>Von einer Waage oder aus CAD. Dient nur zum Vergleich; lassen Sie unbekannte Felder leer.</translation>
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
    <name>heft::LessonGuide</name>
    <message>
        <source>Making the lesson’s recording</source>
        <translation>Die Aufnahme der Lektion wird gemacht</translation>
    </message>
    <message>
        <source>Look once more.</source>
        <translation>Sehen Sie noch einmal hin.</translation>
    </message>
    <message>
        <source>&amp;Lessons</source>
        <translation>&amp;Lektionen</translation>
    </message>
    <message>
        <source>From a &amp;file …</source>
        <translation>Aus einer &amp;Datei …</translation>
    </message>
    <message>
        <source>Open a lesson</source>
        <translation>Eine Lektion öffnen</translation>
    </message>
    <message>
        <source>Lessons (*.json);;All files (*)</source>
        <translation>Lektionen (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>There is no lesson %1.</source>
        <translation>Es gibt keine Lektion %1.</translation>
    </message>
    <message>
        <source>Right.</source>
        <translation>Richtig.</translation>
    </message>
    <message>
        <source>No lesson is running.</source>
        <translation>Es läuft keine Lektion.</translation>
    </message>
    <message>
        <source>Answers come after the last step of a lesson.</source>
        <translation>Antworten folgen nach dem letzten Schritt einer Lektion.</translation>
    </message>
</context>
<context>
    <name>heft::LibraryOnDemand</name>
    <message>
        <source>The library {} is missing. Install the package that holds it.</source>
        <translation>Die Bibliothek {} fehlt. Installieren Sie das Paket, zu dem sie gehört.</translation>
    </message>
    <message>
        <source>The library {} is missing. Install it: apt-get install {}</source>
        <translation>Die Bibliothek {} fehlt. Installieren Sie sie: apt-get install {}</translation>
    </message>
    <message>
        <source>The library {} has no {}: it is of another version.</source>
        <translation>Der Bibliothek {} fehlt {}: Sie ist von einer anderen Version.</translation>
    </message>
</context>
<context>
    <name>heft::LiveBoard</name>
    <message>
        <source>Free motion</source>
        <translation>Freie Bewegung</translation>
    </message>
    <message>
        <source>Standing poses</source>
        <translation>Standhaltungen</translation>
    </message>
    <message>
        <source>Starts a new recording (mass and centre of mass only)</source>
        <translation>Beginnt neu; nur Masse und Schwerpunkt, aus still gehaltenen Haltungen</translation>
    </message>
    <message>
        <source>NEXT POSE</source>
        <translation>NÄCHSTE HALTUNG</translation>
    </message>
    <message>
        <source>DO THIS NOW</source>
        <translation>JETZT TUN</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Dorthin fahren</translation>
    </message>
    <message>
        <source>Show me</source>
        <translation>Vormachen</translation>
    </message>
    <message>
        <source>The virtual arm performs the suggested motion</source>
        <translation>Der virtuelle Arm macht die vorgeschlagene Bewegung von selbst</translation>
    </message>
    <message>
        <source>band = uncertainty over time</source>
        <translation>Band = Unsicherheit über der Zeit</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Haltungen</translation>
    </message>
    <message>
        <source>Remove last pose</source>
        <translation>Letzte Haltung wegnehmen</translation>
    </message>
    <message>
        <source>Move automatically</source>
        <translation>Von selbst bewegen</translation>
    </message>
    <message>
        <source>The virtual arm moves around as if guided by hand</source>
        <translation>Der virtuelle Arm wandert umher, als führte ihn jemand</translation>
    </message>
    <message>
        <source>Change the tool</source>
        <translation>Werkzeug wechseln</translation>
    </message>
    <message>
        <source>Swaps the hidden tool; Heft should notice</source>
        <translation>Ein anderes verborgenes Werkzeug wird angeschraubt; Heft muss es merken</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 Hz, %2</source>
        <translation>%1 Hz, %2</translation>
    </message>
    <message numerus="yes">
        <source>%n unmatched sample(s)</source>
        <translation>
            <numerusform>%n Teil ohne Gegenstück</numerusform>
            <numerusform>%n Teile ohne Gegenstück</numerusform>
        </translation>
    </message>
    <message>
        <source>Waiting for the first data</source>
        <translation>Warten auf die ersten Daten</translation>
    </message>
    <message>
        <source>Motion and force are both needed.</source>
        <translation>Bewegung und Kraft werden beide gebraucht.</translation>
    </message>
    <message>
        <source>Tilt the tool as the ghost shows, and hold it still</source>
        <translation>Neigen Sie das Werkzeug, wie der Schatten es zeigt, und halten Sie es still</translation>
    </message>
    <message>
        <source>After it: mass ± %1 g, centre of mass ± %2 mm.</source>
        <translation>Danach: Masse ± %1 g, Schwerpunkt ± %2 mm.</translation>
    </message>
    <message>
        <source>One second is enough.</source>
        <translation>Eine ruhige Sekunde genügt.</translation>
    </message>
    <message>
        <source>Tilt the tool another way, and hold it still</source>
        <translation>Neigen Sie das Werkzeug anders und halten Sie es still</translation>
    </message>
    <message>
        <source>Move the tool, in all directions</source>
        <translation>Bewegen Sie das Werkzeug in alle Richtungen</translation>
    </message>
    <message>
        <source>Tilt the tool about all its axes, then turn it faster</source>
        <translation>Neigen Sie das Werkzeug um alle Achsen, dann drehen Sie es schneller</translation>
    </message>
    <message>
        <source>about %1 s more</source>
        <translation>noch etwa %1 s</translation>
    </message>
    <message>
        <source>The tool was changed at %1 s. The numbers above are for the new one.</source>
        <translation>Das Werkzeug wurde bei %1 s gewechselt. Die Angaben oben gelten für das neue.</translation>
    </message>
    <message>
        <source>Pose %1: %2</source>
        <translation>Haltung %1: %2</translation>
    </message>
    <message>
        <source>Still to come</source>
        <translation>Kommt noch</translation>
    </message>
    <message>
        <source>Heft captures a pose automatically once the tool has been still for a second.</source>
        <translation>Heft nimmt eine Haltung von selbst auf, sobald das Werkzeug eine Sekunde stillsteht.</translation>
    </message>
    <message>
        <source>Mass %1 ± %2 kg, centre of mass ± %3 mm</source>
        <translation>Masse %1 ± %2 kg, Schwerpunkt ± %3 mm</translation>
    </message>
    <message>
        <source>Mass and centre of mass are not known yet.</source>
        <translation>Masse und Schwerpunkt sind noch nicht bekannt.</translation>
    </message>
    <message>
        <source>ONE MOMENT</source>
        <translation>EINEN MOMENT</translation>
    </message>
    <message>
        <source>YOU CAN STOP</source>
        <translation>SIE KÖNNEN AUFHÖREN</translation>
    </message>
    <message>
        <source>Press “Stop and save” to see the result.</source>
        <translation>Drücken Sie „Beenden und behalten“, um das Ergebnis zu sehen.</translation>
    </message>
    <message>
        <source>NO DATA</source>
        <translation>KEINE DATEN</translation>
    </message>
    <message>
        <source>Connection lost. Reconnecting automatically…</source>
        <translation>Die Verbindung ist unterbrochen. Heft versucht es von selbst weiter.</translation>
    </message>
    <message>
        <source>No response yet. Still trying…</source>
        <translation>Noch antwortet nichts. Heft versucht es weiter.</translation>
    </message>
    <message>
        <source>Data received so far is kept. Check the cable, the network and the sending program.</source>
        <translation>Was bisher kam, bleibt erhalten. Sehen Sie nach Kabel, Netzwerk und dem Programm am anderen Ende.</translation>
    </message>
    <message>
        <source>Check that it is switched on and the address is correct.</source>
        <translation>Ist es eingeschaltet, und stimmt die Adresse?</translation>
    </message>
    <message>
        <source>Bring the arm to another posture</source>
        <translation>Bringen Sie den Arm in eine andere Haltung</translation>
    </message>
    <message>
        <source>Prefer free motion?</source>
        <translation>Lieber freie Bewegung?</translation>
    </message>
    <message>
        <source>Prefer standing poses?</source>
        <translation>Lieber stehende Posen?</translation>
    </message>
    <message>
        <source>Starts a new recording (mass, centre of mass and inertia)</source>
        <translation>Beginnt neu; Masse, Schwerpunkt und Trägheit aus freier Bewegung</translation>
    </message>
    <message>
        <source>Progress through the suggested motion</source>
        <translation>Fortschritt in der vorgeschlagenen Bewegung</translation>
    </message>
    <message>
        <source>Current estimate</source>
        <translation>Aktuelle Schätzung</translation>
    </message>
    <message>
        <source>The tool is touching something. This part is excluded.</source>
        <translation>Gerade berührt etwas das Werkzeug. Dieser Abschnitt wird ausgelassen.</translation>
    </message>
    <message numerus="yes">
        <source>%n possible contact(s). You can review them in Mark.</source>
        <translation>
            <numerusform>%n möglicher Kontakt. Prüfen Sie ihn unter Markieren.</numerusform>
            <numerusform>%n mögliche Kontakte. Prüfen Sie sie unter Markieren.</numerusform>
        </translation>
    </message>
    <message>
        <source>DOES NOT MATCH THE SETUP</source>
        <translation>ANDERS ALS ANGEGEBEN</translation>
    </message>
</context>
<context>
    <name>heft::LiveRun</name>
    <message>
        <source>The source sends %1 joints, the robot has %2: name the right robot in the setup file.</source>
        <translation>Die Quelle sendet %1 Gelenke, der Roboter hat %2: Nennen Sie den richtigen Roboter in der Aufbaudatei.</translation>
    </message>
    <message>
        <source>The folder %1 for recordings cannot be created.</source>
        <translation>Der Ordner %1 für Aufzeichnungen lässt sich nicht anlegen.</translation>
    </message>
</context>
<context>
    <name>heft::LiveStage</name>
    <message>
        <source>Paused at %1 s</source>
        <translation>Pause bei %1 s</translation>
    </message>
    <message>
        <source>● Standing poses  %1 s</source>
        <translation>● Standhaltungen  %1 s</translation>
    </message>
    <message>
        <source>● Recording %1 s   %2 Hz</source>
        <translation>● Aufzeichnung %1 s   %2 Hz</translation>
    </message>
    <message>
        <source>Move like this</source>
        <translation>So bewegen</translation>
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
    <message>
        <source>Robot and sensor …</source>
        <translation>Roboter und Sensor …</translation>
    </message>
    <message>
        <source>Choose columns and units …</source>
        <translation>Spalten und Einheiten wählen …</translation>
    </message>
</context>
<context>
    <name>heft::Manual</name>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Back to the step (F1 or Esc)</source>
        <translation>Zurück zum Schritt (F1 oder Esc)</translation>
    </message>
</context>
<context>
    <name>heft::MarkPanel</name>
    <message>
        <source>needs a recording</source>
        <translation>nach der Aufnahme</translation>
    </message>
    <message>
        <source>all poses are used</source>
        <translation>alle Stellungen benutzt</translation>
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
        <source>When was the tool free (not touching anything)?</source>
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
        <source>Heft suggests</source>
        <translation>Heft schlägt vor</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
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
        <source>Show this segment</source>
        <translation>Diesen Abschnitt zeigen</translation>
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
        <source>No, free motion</source>
        <translation>Nein, es war frei</translation>
    </message>
    <message>
        <source>All segments</source>
        <translation>Alle Abschnitte</translation>
    </message>
    <message>
        <source>%1?</source>
        <translation>%1?</translation>
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
        <source>Usable data</source>
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
        <source>&amp;Mark the segment shown</source>
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
        <source>mark needs an open recording.</source>
        <translation>mark braucht eine offene Aufnahme.</translation>
    </message>
    <message>
        <source>Drag an edge to adjust it · Ctrl+Z to undo</source>
        <translation>Eine Kante lässt sich verschieben · Strg+Z macht rückgängig</translation>
    </message>
    <message>
        <source>checking …</source>
        <translation>wird geprüft …</translation>
    </message>
    <message>
        <source>nothing found</source>
        <translation>nichts gefunden</translation>
    </message>
    <message>
        <source>Nothing was found.</source>
        <translation>Es wurde nichts gefunden.</translation>
    </message>
    <message>
        <source>Paint it yourself</source>
        <translation>Selbst markieren</translation>
    </message>
    <message>
        <source>Checking the recording …</source>
        <translation>Die Aufnahme wird geprüft …</translation>
    </message>
    <message>
        <source>Accept and continue</source>
        <translation>Übernehmen und weiter</translation>
    </message>
    <message>
        <source>Accept both and continue</source>
        <translation>Beide übernehmen, weiter</translation>
    </message>
    <message>
        <source>Accept all %1 and continue</source>
        <translation>Alle %1 übernehmen, weiter</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>drag along the bar</source>
        <translation>am Balken ziehen</translation>
    </message>
    <message>
        <source>Also excluded at each end, where the arm is gripped and released</source>
        <translation>An beiden Enden auch weggelassen, wo man den Arm greift und loslässt</translation>
    </message>
    <message>
        <source>Excluded at each end</source>
        <translation>An jedem Ende weggelassen</translation>
    </message>
    <message>
        <source>excluded at each end</source>
        <translation>an jedem Ende weggelassen</translation>
    </message>
    <message>
        <source>A segment has to end after it begins.</source>
        <translation>Ein Abschnitt muss nach seinem Anfang enden.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>confidence %1 %</source>
        <translation>Sicherheit %1 %</translation>
    </message>
    <message>
        <source>Paint in the plots, too</source>
        <translation>Auch in den Kurven malen</translation>
    </message>
    <message>
        <source>Drag in the plots to label a range instead of zooming</source>
        <translation>Ziehen über die Kurven markiert einen Abschnitt, statt zu vergrößern</translation>
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
        <source>standing poses, all used</source>
        <translation>ruhende Stellungen, alle benutzt</translation>
    </message>
    <message>
        <source>pose %1</source>
        <translation>Stellung %1</translation>
    </message>
    <message>
        <source>Zoom to this segment</source>
        <translation>Diesen Abschnitt vergrößern</translation>
    </message>
    <message>
        <source>Mark as %1</source>
        <translation>Als %1 markieren</translation>
    </message>
    <message>
        <source>Segments of the recording: free, contact or ignored</source>
        <translation>Welche Abschnitte der Aufnahme nichts berührt haben</translation>
    </message>
</context>
<context>
    <name>heft::MeshForm</name>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Drop the file here, or choose it. Closed solids work best (STL, OBJ, PLY, DAE, glTF).</source>
        <translation>Ziehen Sie die Datei hierher, oder wählen Sie sie aus. Am besten sind geschlossene Körper (STL, OBJ, PLY, DAE, glTF).</translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation>Datei wählen …</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>%1 wird gelesen …</translation>
    </message>
    <message>
        <source>Another file …</source>
        <translation>Andere Datei …</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Einheit der Datei</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>The longest side is then %1.</source>
        <translation>Die längste Seite ist dann %1.</translation>
    </message>
    <message>
        <source>Snap to sensor face</source>
        <translation>Auf die Sensorfläche setzen</translation>
    </message>
    <message>
        <source>Centres its bounding box on the sensor face. Otherwise the file origin is placed at the sensor origin.</source>
        <translation>Sein Kasten beginnt dann mittig am Sensor. Sonst liegt der Ursprung der Datei im Sensor.</translation>
    </message>
    <message>
        <source>The longest side is %1 in the file. Assuming %2, that is %3.</source>
        <translation>Die längste Seite ist in der Datei %1. In %2 sind das %3.</translation>
    </message>
    <message>
        <source>Treat it as a thin shell of 2 mm</source>
        <translation>Als dünne Schale von 2 mm nehmen</translation>
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
        <source>Running all methods…</source>
        <translation>Jedes Verfahren wiegt das Werkzeug der Reihe nach …</translation>
    </message>
</context>
<context>
    <name>heft::MountedList</name>
    <message>
        <source>Is it between flange and tool, and not entered into the controller elsewhere?</source>
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
        <source>Total on the flange</source>
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
        <source>Inertia is approximated by a compact aluminium body.</source>
        <translation>Seine Trägheit wird wie die eines kompakten Aluminiumkörpers dieses Gewichts angenommen.</translation>
    </message>
    <message>
        <source>Add it</source>
        <translation>Dazunehmen</translation>
    </message>
</context>
<context>
    <name>heft::ObjectCard</name>
    <message>
        <source>Something picked up?</source>
        <translation>Etwas aufgenommen?</translation>
    </message>
    <message>
        <source>Picked up in this recording</source>
        <translation>In dieser Aufnahme aufgenommen</translation>
    </message>
    <message>
        <source>Compare with a recording without it …</source>
        <translation>Mit einer Aufnahme ohne es vergleichen …</translation>
    </message>
    <message>
        <source>What is carried</source>
        <translation>Was getragen wird</translation>
    </message>
    <message>
        <source>Heft weighs what is carried …</source>
        <translation>Heft wiegt, was getragen wird …</translation>
    </message>
    <message>
        <source>From the parts of this recording with and without it, in the sensor’s axes.</source>
        <translation>Aus den Teilen dieser Aufnahme mit und ohne es, in den Achsen des Sensors.</translation>
    </message>
    <message>
        <source>The same tool without the object</source>
        <translation>Dasselbe Werkzeug ohne den Gegenstand</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Heft can weigh what the tool carries: from this recording, if the object is picked up or put down in it, or with a second recording of the tool alone.</source>
        <translation>Heft kann wiegen, was das Werkzeug trägt: aus dieser Aufnahme, wenn der Gegenstand darin aufgenommen oder abgelegt wird, oder mit einer zweiten Aufnahme des Werkzeugs allein.</translation>
    </message>
    <message>
        <source>This recording minus %1, in the sensor’s axes.</source>
        <translation>Diese Aufnahme abzüglich %1, in den Achsen des Sensors.</translation>
    </message>
    <message>
        <source>Applied corrections are not used here.</source>
        <translation>Angewandte Berichtigungen gelten hier nicht.</translation>
    </message>
</context>
<context>
    <name>heft::OverviewStrip</name>
    <message>
        <source>Which part of the recording the plots show</source>
        <translation>Welchen Teil der Aufnahme die Kurven zeigen</translation>
    </message>
    <message>
        <source>The whole recording; drag the frame to see another part</source>
        <translation>Die ganze Aufnahme; ziehen Sie den Rahmen, um einen anderen Teil zu sehen</translation>
    </message>
    <message>
        <source>Whole recording</source>
        <translation>Ganze Aufnahme</translation>
    </message>
</context>
<context>
    <name>heft::PartsList</name>
    <message>
        <source>Remove part %1</source>
        <translation>Teil %1 wegnehmen</translation>
    </message>
    <message>
        <source>Add a part</source>
        <translation>Teil hinzufügen</translation>
    </message>
    <message>
        <source>%1 …</source>
        <translation>%1 …</translation>
    </message>
</context>
<context>
    <name>heft::PayloadForm</name>
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
        <source>The centre needs three numbers, or none.</source>
        <translation>Der Schwerpunkt braucht drei Zahlen oder keine.</translation>
    </message>
    <message>
        <source>The inertia needs Ixx, Iyy and Izz, or nothing; empty products count as zero.</source>
        <translation>Die Trägheit braucht Ixx, Iyy und Izz oder nichts; leere Deviationsmomente zählen als null.</translation>
    </message>
    <message>
        <source>The weight must be a number, zero or above.</source>
        <translation>Das Gewicht muss eine Zahl von null an sein.</translation>
    </message>
    <message>
        <source>The weight must be a number above zero.</source>
        <translation>Das Gewicht muss eine Zahl über null sein.</translation>
    </message>
</context>
<context>
    <name>heft::PlaceForm</name>
    <message>
        <source>Centre of the near face, relative to the sensor face</source>
        <translation>Mitte des nahen Endes, von der Sensorfläche aus</translation>
    </message>
    <message>
        <source>Tilted about the sensor’s axes</source>
        <translation>Geneigt um die Achsen des Sensors</translation>
    </message>
    <message>
        <source>Place along %1</source>
        <translation>Lage entlang %1</translation>
    </message>
    <message>
        <source>Tilt about %1</source>
        <translation>Neigung um %1</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>um %1</translation>
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
        <source>%1 of %2 s</source>
        <translation>%1 von %2 s</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Anhalten (Leertaste)</translation>
    </message>
    <message>
        <source>Speed, loop and single steps</source>
        <translation>Geschwindigkeit, Schleife und Einzelschritte</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1-fach</translation>
    </message>
    <message>
        <source>Loop what the plots show</source>
        <translation>Wiederholen, was die Kurven zeigen</translation>
    </message>
    <message>
        <source>One step back</source>
        <translation>Ein Schritt zurück</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>pose %1 of %2</source>
        <translation>Stellung %1 von %2</translation>
    </message>
    <message>
        <source>One step forward</source>
        <translation>Ein Schritt vor</translation>
    </message>
</context>
<context>
    <name>heft::Preferences</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>&amp;Recordings folder</source>
        <translation>Ordner für &amp;Aufnahmen</translation>
    </message>
    <message>
        <source>Recordings folder</source>
        <translation>Ordner für Aufnahmen</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>Links, Rechts</translation>
    </message>
    <message>
        <source>Beginning, end of the recording</source>
        <translation>Anfang, Ende der Aufnahme</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Pos1, Ende</translation>
    </message>
    <message>
        <source>Next part of the window</source>
        <translation>Nächster Teil des Fensters</translation>
    </message>
    <message>
        <source>Press the button that has the focus</source>
        <translation>Die Schaltfläche mit dem Fokus drücken</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>&amp;Masses in</source>
        <translation>&amp;Massen in</translation>
    </message>
    <message>
        <source>L&amp;engths in</source>
        <translation>&amp;Längen in</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>T&amp;orques in</source>
        <translation>M&amp;omente in</translation>
    </message>
    <message>
        <source>&amp;Angles in</source>
        <translation>&amp;Winkel in</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>radians</source>
        <translation>Bogenmaß</translation>
    </message>
    <message>
        <source>For the result and the plots. Files keep the units of their format, and lengths that you enter are in mm.</source>
        <translation>Für Ergebnis und Kurven. Dateien behalten die Einheiten ihres Formats; Längen geben Sie in mm ein.</translation>
    </message>
    <message>
        <source>Back or forward in time; with Shift, further</source>
        <translation>Zeit zurück oder vor; mit Umschalt weiter</translation>
    </message>
    <message>
        <source>Zoom the plots; whole recording</source>
        <translation>Kurven vergrößern, verkleinern; alles</translation>
    </message>
</context>
<context>
    <name>heft::ProofCard</name>
    <message>
        <source>The numbers have changed since; prove them again.</source>
        <translation>Die Zahlen haben sich seither geändert; beweisen Sie sie neu.</translation>
    </message>
    <message>
        <source>Prove on a recording …</source>
        <translation>An einer Aufnahme beweisen …</translation>
    </message>
    <message>
        <source>Tool passport …</source>
        <translation>Werkzeugpass …</translation>
    </message>
    <message>
        <source>Prove needs a result.</source>
        <translation>Beweisen braucht ein Ergebnis.</translation>
    </message>
    <message>
        <source>The numbers come from %1 itself: prove them on another recording.</source>
        <translation>Die Zahlen stammen aus %1 selbst: Beweisen Sie sie an einer anderen Aufnahme.</translation>
    </message>
    <message>
        <source>Proving the numbers</source>
        <translation>Die Zahlen werden bewiesen</translation>
    </message>
    <message>
        <source>Prove on a recording</source>
        <translation>An einer Aufnahme beweisen</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Tool passport</source>
        <translation>Werkzeugpass</translation>
    </message>
    <message>
        <source>What is the tool called?</source>
        <translation>Wie heißt das Werkzeug?</translation>
    </message>
    <message>
        <source>Save the passport</source>
        <translation>Den Pass speichern</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
    <message>
        <source>Saved %1, compared with %2.</source>
        <translation>%1 gespeichert, verglichen mit %2.</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Is it right on the robot?</source>
        <translation>Stimmt es am Roboter?</translation>
    </message>
    <message>
        <source>Checking the numbers with that recording …</source>
        <translation>Die Zahlen werden mit dieser Aufnahme geprüft …</translation>
    </message>
    <message>
        <source>Load the file into the controller, guide the tool in all directions for ten seconds without touching anything, and let Heft check the numbers.</source>
        <translation>Laden Sie die Datei in die Steuerung, führen Sie das Werkzeug zehn Sekunden lang in alle Richtungen, ohne etwas zu berühren, und lassen Sie Heft die Zahlen prüfen.</translation>
    </message>
    <message>
        <source>Prove on live data</source>
        <translation>An laufenden Daten beweisen</translation>
    </message>
    <message>
        <source>No live data: start listening to the robot under Record, then guide the tool.</source>
        <translation>Keine laufenden Daten: Hören Sie unter „Aufnehmen“ dem Roboter zu und führen Sie dann das Werkzeug.</translation>
    </message>
</context>
<context>
    <name>heft::RealityPanel</name>
    <message>
        <source>needs a recording</source>
        <translation>nach der Aufnahme</translation>
    </message>
    <message>
        <source>what is wrong?</source>
        <translation>was stimmt nicht?</translation>
    </message>
    <message>
        <source>looking …</source>
        <translation>sucht …</translation>
    </message>
    <message numerus="yes">
        <source>%n correction(s) applied</source>
        <translation>
            <numerusform>%n Berichtigung angewandt</numerusform>
            <numerusform>%n Berichtigungen angewandt</numerusform>
        </translation>
    </message>
    <message>
        <source>not run yet</source>
        <translation>noch nicht gesucht</translation>
    </message>
    <message>
        <source>out of date, run again</source>
        <translation>noch einmal suchen</translation>
    </message>
    <message numerus="yes">
        <source>%n cause(s) to apply</source>
        <translation>
            <numerusform>%n Ursache anzuwenden</numerusform>
            <numerusform>%n Ursachen anzuwenden</numerusform>
        </translation>
    </message>
    <message>
        <source>unexplained error</source>
        <translation>etwas Unbekanntes</translation>
    </message>
    <message>
        <source>two causes possible</source>
        <translation>zwei Ursachen möglich</translation>
    </message>
    <message>
        <source>the model fits</source>
        <translation>das Modell passt</translation>
    </message>
    <message>
        <source>Looking for causes</source>
        <translation>Ursachen suchen</translation>
    </message>
    <message>
        <source>The search was stopped.</source>
        <translation>Die Suche wurde angehalten.</translation>
    </message>
    <message>
        <source>Making a recording to practise on</source>
        <translation>Eine Übungsaufnahme entsteht</translation>
    </message>
    <message>
        <source>apply “%1”</source>
        <translation>„%1“ anwenden</translation>
    </message>
    <message>
        <source>Checking on %1</source>
        <translation>Prüfen an %1</translation>
    </message>
    <message>
        <source>Open a recording first.</source>
        <translation>Öffnen Sie zuerst eine Aufnahme.</translation>
    </message>
    <message>
        <source>Looking for causes …</source>
        <translation>Ursachen werden gesucht …</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>What does the simulation get wrong?</source>
        <translation>Was macht die Simulation falsch?</translation>
    </message>
    <message>
        <source>Open a recording first, or take one from the menu Practice.</source>
        <translation>Öffnen Sie zuerst eine Aufnahme, oder nehmen Sie eine aus dem Menü Üben.</translation>
    </message>
    <message>
        <source>Go to Record</source>
        <translation>Zu Aufnehmen</translation>
    </message>
    <message>
        <source>What is wrong with this recording?</source>
        <translation>Was stimmt mit dieser Aufnahme nicht?</translation>
    </message>
    <message numerus="yes">
        <source>%n correction(s) of an earlier check are part of the result.</source>
        <translation>
            <numerusform>%n Berichtigung einer früheren Prüfung ist Teil des Ergebnisses.</numerusform>
            <numerusform>%n Berichtigungen einer früheren Prüfung sind Teil des Ergebnisses.</numerusform>
        </translation>
    </message>
    <message>
        <source>Heft looks for what the model of a rigid tool cannot explain.</source>
        <translation>Heft sucht, was das Modell eines starren Werkzeugs nicht erklären kann.</translation>
    </message>
    <message>
        <source>Run reality check</source>
        <translation>Ursachen suchen</translation>
    </message>
    <message>
        <source>Run again</source>
        <translation>Noch einmal suchen</translation>
    </message>
    <message>
        <source>diagnose needs an open recording.</source>
        <translation>diagnose braucht eine offene Aufnahme.</translation>
    </message>
    <message>
        <source>%1 is not applied.</source>
        <translation>%1 ist nicht angewandt.</translation>
    </message>
    <message>
        <source>apply needs a reality check first: diagnose.</source>
        <translation>apply braucht zuerst eine Realitätsprüfung: diagnose.</translation>
    </message>
    <message>
        <source>%1 cannot be applied here; found were: %2.</source>
        <translation>%1 lässt sich hier nicht anwenden; gefunden wurden: %2.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>check needs a reality check first: diagnose.</source>
        <translation>check braucht zuerst eine Realitätsprüfung: diagnose.</translation>
    </message>
    <message>
        <source>%1 is not open beside the shown recording.</source>
        <translation>%1 ist nicht neben der gezeigten Aufnahme offen.</translation>
    </message>
    <message>
        <source>guess needs a recording to practise on.</source>
        <translation>guess braucht eine Übungsaufnahme.</translation>
    </message>
    <message>
        <source>Something pulls from here</source>
        <translation>Hierher zieht etwas</translation>
    </message>
    <message>
        <source>within %1 cm, %2 N on average</source>
        <translation>auf %1 cm genau, im Mittel %2 N</translation>
    </message>
    <message>
        <source>To find out more: record the same motion once more, without touching anything.</source>
        <translation>Um mehr zu erfahren: Nehmen Sie dieselbe Bewegung noch einmal auf, ohne etwas zu berühren.</translation>
    </message>
    <message>
        <source>To decide about “%1”: %2</source>
        <translation>Um über „%1“ zu entscheiden: %2</translation>
    </message>
    <message>
        <source>free parts fit the model</source>
        <translation>freie Teile passen</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Look at the curves below the arm, then guess</source>
        <translation>Sehen Sie sich die Kurven unter dem Arm an und raten Sie</translation>
    </message>
    <message>
        <source>Apply a correction to see what it changes · Ctrl+Z to undo</source>
        <translation>Eine Korrektur anwenden und sehen, was sie ändert · Strg+Z macht rückgängig</translation>
    </message>
    <message>
        <source>Stopping …</source>
        <translation>Hält an …</translation>
    </message>
    <message>
        <source>Show force and torque</source>
        <translation>Kraft und Moment zeigen</translation>
    </message>
    <message>
        <source>Show the difference</source>
        <translation>Die Abweichung zeigen</translation>
    </message>
    <message>
        <source>What is shown below the arm</source>
        <translation>Was unter dem Arm steht</translation>
    </message>
    <message>
        <source>Drag a slider; the recording stays as it is</source>
        <translation>Ziehen Sie einen Regler; die Aufnahme bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>What if …?</source>
        <translation>Was wäre, wenn …?</translation>
    </message>
    <message>
        <source>All off</source>
        <translation>Alle aus</translation>
    </message>
    <message>
        <source>&amp;What if …?</source>
        <translation>&amp;Was wäre, wenn …?</translation>
    </message>
    <message>
        <source>Move one slider: the curves and the numbers below the arm follow your hand. The recording stays as it is.</source>
        <translation>Ziehen Sie einen Regler: Kurven und Zahlen unter dem Arm folgen Ihrer Hand. Die Aufnahme bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>Back to the check</source>
        <translation>Zurück zur Prüfung</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>End the lesson</source>
        <translation>Lektion beenden</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>check the setup</source>
        <translation>den Aufbau prüfen</translation>
    </message>
    <message>
        <source>remove the correction “%1”</source>
        <translation>die Berichtigung „%1“ entfernen</translation>
    </message>
    <message>
        <source>Heft compares the recording with the simulation, and with 200 simulated clean recordings.</source>
        <translation>Heft vergleicht die Aufnahme mit der Simulation und mit 200 simulierten sauberen Aufnahmen.</translation>
    </message>
    <message>
        <source>It contains one hidden fault. Inspect it, then guess.</source>
        <translation>Sie enthält einen versteckten Fehler. Sehen Sie sie an, dann tippen Sie.</translation>
    </message>
    <message>
        <source>The marks have changed since the last check.</source>
        <translation>Die Marken haben sich seit der letzten Prüfung geändert.</translation>
    </message>
    <message>
        <source>Continue to Export</source>
        <translation>Weiter zu Ausgeben</translation>
    </message>
    <message>
        <source>Run reality chec&amp;k</source>
        <translation>Reali&amp;tätsprüfung starten</translation>
    </message>
    <message>
        <source>Save repor&amp;t …</source>
        <translation>Be&amp;richt speichern …</translation>
    </message>
    <message>
        <source>&amp;New exercise</source>
        <translation>&amp;Neue Übung</translation>
    </message>
    <message>
        <source>Exercise &amp;%1</source>
        <translation>Übung &amp;%1</translation>
    </message>
    <message>
        <source>There is no quantity called %1.</source>
        <translation>Es gibt keine Größe namens %1.</translation>
    </message>
    <message>
        <source>%1 is not one of the faults to guess.</source>
        <translation>%1 ist keiner der Fehler zum Tippen.</translation>
    </message>
    <message>
        <source>use other conventions than stated</source>
        <translation>andere Konventionen als angegeben</translation>
    </message>
    <message>
        <source>Heft compares the poses with each other, and with a rigid tool under gravity.</source>
        <translation>Heft vergleicht die Haltungen miteinander und mit einem starren Werkzeug unter Schwerkraft.</translation>
    </message>
    <message>
        <source>The numbers follow other conventions</source>
        <translation>Die Zahlen folgen anderen Konventionen</translation>
    </message>
    <message>
        <source>Apply these conventions first; the rest of this page assumes them.</source>
        <translation>Wenden Sie zuerst diese Konventionen an; der Rest dieser Seite setzt sie voraus.</translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s) already compensated</source>
        <translation>
            <numerusform>%n Befund schon ausgeglichen</numerusform>
            <numerusform>%n Befunde schon ausgeglichen</numerusform>
        </translation>
    </message>
    <message>
        <source>clearest here</source>
        <translation>hier am besten zu sehen</translation>
    </message>
    <message>
        <source>More than one interpretation fits, each with a different mass. Choose the right one; Heft does not guess.</source>
        <translation>Mehr als eine Deutung passt, jede mit einer anderen Masse. Wählen Sie die richtige; Heft rät nicht.</translation>
    </message>
    <message>
        <source>Making the recording without the fault</source>
        <translation>Aufnahme ohne den Fehler wird erzeugt</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 · %2 s</source>
        <translation>%1 · %2 s</translation>
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
        <source>Open a recording of the arm moving with its tool. Heft estimates mass, centre of mass and inertia, and how certain each value is.</source>
        <translation>Öffnen Sie eine Aufnahme, in der sich der Arm mit seinem Werkzeug bewegt. Heft findet Masse, Schwerpunkt und Trägheit und sagt, wie sicher jeder Wert ist.</translation>
    </message>
    <message>
        <source>What a recording contains</source>
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
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Time, joint angles or sensor poses, and force and torque: a CSV, a ROS bag, MCAP or HDF5. A file NAME.meta.json in the same folder can specify the robot and the sensor mounting.</source>
        <translation>Zeit, Gelenkwinkel oder Sensorposen, Kraft und Moment: als CSV, ROS-Bag, MCAP oder HDF5. Eine Datei NAME.meta.json daneben kann den Roboter nennen und wie der Sensor angebaut ist.</translation>
    </message>
    <message>
        <source>The tool was changed. Heft now learns the new one.</source>
        <translation>Das Werkzeug wurde gewechselt. Heft lernt jetzt das neue kennen.</translation>
    </message>
    <message>
        <source>waiting for data</source>
        <translation>wartet auf Daten</translation>
    </message>
    <message numerus="yes">
        <source>%n pose(s), recording</source>
        <translation>
            <numerusform>%n Haltung, läuft</numerusform>
            <numerusform>%n Haltungen, läuft</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 s, recording</source>
        <translation>%1 s, läuft</translation>
    </message>
    <message>
        <source>Listen to your robot</source>
        <translation>Ihrem Roboter zuhören</translation>
    </message>
    <message>
        <source>Heft only listens. It never moves the robot or changes settings.</source>
        <translation>Heft hört nur zu: Es bewegt nichts und ändert nichts.</translation>
    </message>
    <message>
        <source>Connect and record</source>
        <translation>Verbinden und aufzeichnen</translation>
    </message>
    <message>
        <source>Try it without a robot</source>
        <translation>Ohne Roboter ausprobieren</translation>
    </message>
    <message>
        <source>Drag the virtual arm with the mouse as if guiding it by hand, and find out what its hidden tool weighs.</source>
        <translation>Der virtuelle Arm folgt Ihrer Maus wie ein handgeführter Ihrer Hand. Finden Sie heraus, was sein verborgenes Werkzeug wiegt.</translation>
    </message>
    <message>
        <source>Live robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Open files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Virtual arm</source>
        <translation>Virtueller Arm</translation>
    </message>
    <message>
        <source>Which tool does it carry?</source>
        <translation>Welches Werkzeug trägt er?</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Leicht</translation>
    </message>
    <message>
        <source>below 0.5 kg</source>
        <translation>unter 0,5 kg</translation>
    </message>
    <message>
        <source>Heavy</source>
        <translation>Schwer</translation>
    </message>
    <message>
        <source>over 1.1 kg</source>
        <translation>über 1,1 kg</translation>
    </message>
    <message>
        <source>How to guide it</source>
        <translation>So führen Sie ihn</translation>
    </message>
    <message>
        <source>Or use the arrow keys and Page Up/Down; hold Shift to rotate.</source>
        <translation>Oder benutzen Sie die Pfeiltasten, Bild auf und Bild ab; mit Umschalt drehen sie.</translation>
    </message>
    <message>
        <source>The coach suggests the most useful motion. Click &quot;Show me&quot; to see it.</source>
        <translation>Der Trainer sagt, was am meisten hilft. Lassen Sie es sich vormachen, wenn Sie mögen.</translation>
    </message>
    <message>
        <source>Standing poses</source>
        <translation>Standhaltungen</translation>
    </message>
    <message>
        <source>Start guiding</source>
        <translation>Führen beginnen</translation>
    </message>
    <message>
        <source>Hold the tool still in several orientations</source>
        <translation>Halten Sie das Werkzeug still, in mehreren Neigungen</translation>
    </message>
    <message>
        <source>Heft captures a pose automatically after one second without motion. Touch nothing with the tool.</source>
        <translation>Heft nimmt eine Haltung nach einer ruhigen Sekunde von selbst auf. Berühren Sie mit dem Werkzeug nichts.</translation>
    </message>
    <message>
        <source>Move the arm – Heft is recording</source>
        <translation>Bewegen Sie den Arm. Heft hört zu.</translation>
    </message>
    <message>
        <source>Guide it as usual. Don’t let the tool touch anything.</source>
        <translation>Führen Sie ihn wie immer. Berühren Sie mit dem Werkzeug nichts.</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Stop and save</source>
        <translation>Beenden und behalten</translation>
    </message>
    <message>
        <source>Nothing was recorded.</source>
        <translation>Es wurde nichts aufgezeichnet.</translation>
    </message>
    <message>
        <source>The virtual arm did not start.</source>
        <translation>Der virtuelle Arm ist nicht gestartet.</translation>
    </message>
    <message>
        <source>Nothing is being recorded: begin with live virtual or live replay.</source>
        <translation>Es wird nichts aufgezeichnet: Beginnen Sie mit live virtual oder live replay.</translation>
    </message>
    <message>
        <source>Move the arm as the coach suggests, then press “Stop and save”</source>
        <translation>Bewegen Sie den Arm, wie der Trainer sagt, und drücken Sie dann „Beenden und behalten“</translation>
    </message>
    <message>
        <source>%1, paused</source>
        <translation>%1, angehalten</translation>
    </message>
    <message>
        <source>%1, recording</source>
        <translation>%1, Aufnahme läuft</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>What was recorded so far was kept: %1</source>
        <translation>Was bisher aufgenommen war, wurde aufgehoben: %1</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Recording saved: %1</source>
        <translation>Aufnahme gespeichert: %1</translation>
    </message>
    <message>
        <source>Heft Studio</source>
        <translation>Heft Studio</translation>
    </message>
    <message>
        <source>Open a recording first.</source>
        <translation>Öffnen Sie erst eine Aufnahme.</translation>
    </message>
    <message>
        <source>Save the recording</source>
        <translation>Aufnahme speichern</translation>
    </message>
    <message>
        <source>Recordings (*.%1)</source>
        <translation>Aufnahmen (*.%1)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
    <message>
        <source>No recording at hand?</source>
        <translation>Keine Aufnahme zur Hand?</translation>
    </message>
    <message>
        <source>Makes this recording with the simulation and opens it</source>
        <translation>Erzeugt diese Aufnahme mit der Simulation und öffnet sie</translation>
    </message>
    <message>
        <source>Making a sample recording</source>
        <translation>Beispielaufnahme wird erzeugt</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>%1   ·   %2, %3</source>
        <translation>%1   ·   %2, %3</translation>
    </message>
    <message>
        <source>Two-minute tour with a sample</source>
        <translation>Zwei Minuten Rundgang mit einem Beispiel</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Choose a room</source>
        <translation>Raum wählen</translation>
    </message>
    <message>
        <source>Rooms (*.json);;All files (*)</source>
        <translation>Räume (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Remove the room</source>
        <translation>Raum entfernen</translation>
    </message>
    <message>
        <source>Start with a recording</source>
        <translation>Am Anfang steht eine Aufnahme</translation>
    </message>
    <message>
        <source>Drag the tool, or use the arrow keys; hold Shift to rotate</source>
        <translation>Ziehen Sie am Werkzeug, oder benutzen Sie die Pfeiltasten; mit Umschalt drehen</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Zufall</translation>
    </message>
    <message>
        <source>any tool</source>
        <translation>irgendeins</translation>
    </message>
    <message>
        <source>Drag the tool to move the arm.</source>
        <translation>Ziehen Sie am Werkzeug, um den Arm zu bewegen.</translation>
    </message>
    <message>
        <source>Drag a ring to rotate the tool.</source>
        <translation>Ziehen Sie an einem Ring, um das Werkzeug zu drehen.</translation>
    </message>
    <message>
        <source>Nothing has been received yet.</source>
        <translation>Es wurde noch nichts empfangen.</translation>
    </message>
    <message>
        <source>At least two poses are needed.</source>
        <translation>Mindestens zwei Haltungen sind nötig.</translation>
    </message>
    <message>
        <source>%1 could not be replayed.</source>
        <translation>%1 konnte nicht abgespielt werden.</translation>
    </message>
    <message>
        <source>There is nothing to show now.</source>
        <translation>Es gibt jetzt nichts zu zeigen.</translation>
    </message>
    <message>
        <source>The sensor’s mounting on the flange is not stated, so Heft assumes the flange’s axes. If it is mounted differently, the inertia and the exported numbers are wrong.</source>
        <translation>Wie der Sensor am Flansch sitzt, ist nicht angegeben; Heft nimmt die Achsen des Flansches an. Sitzt er anders, sind Trägheit und ausgegebene Zahlen falsch.</translation>
    </message>
    <message>
        <source>Specify it now …</source>
        <translation>Jetzt angeben …</translation>
    </message>
    <message>
        <source>A recording is running. Stop it?</source>
        <translation>Eine Aufnahme läuft. Anhalten?</translation>
    </message>
    <message>
        <source>What has been recorded so far is kept in %1.</source>
        <translation>Was bisher aufgenommen wurde, bleibt in %1.</translation>
    </message>
    <message numerus="yes">
        <source>Discard %n pose(s)?</source>
        <translation>
            <numerusform>%n Stellung verwerfen?</numerusform>
            <numerusform>%n Stellungen verwerfen?</numerusform>
        </translation>
    </message>
    <message>
        <source>Save recordin&amp;g as …</source>
        <translation>Aufnahme speichern un&amp;ter …</translation>
    </message>
    <message>
        <source>Open the recordings fol&amp;der</source>
        <translation>&amp;Ordner der Aufnahmen öffnen</translation>
    </message>
    <message>
        <source>Continue recording</source>
        <translation>Weiter aufnehmen</translation>
    </message>
    <message>
        <source>Or guide the virtual arm yourself (third tab above), or find a hidden fault: menu Practice.</source>
        <translation>Oder führen Sie selbst den virtuellen Arm (dritter Reiter oben), oder suchen Sie einen versteckten Fehler: Menü „Üben“.</translation>
    </message>
    <message>
        <source>Choose a r&amp;oom …</source>
        <translation>R&amp;aum wählen …</translation>
    </message>
    <message>
        <source>Walls t&amp;hat were touched</source>
        <translation>Berührte &amp;Wände</translation>
    </message>
    <message>
        <source>In a script, the virtual arm can move for at most %1 s.</source>
        <translation>In einem Skript kann sich der virtuelle Arm höchstens %1 s bewegen.</translation>
    </message>
    <message>
        <source>live pass works only with the virtual arm.</source>
        <translation>live pass gibt es nur mit dem virtuellen Arm.</translation>
    </message>
</context>
<context>
    <name>heft::RecordingList</name>
    <message>
        <source>In this session</source>
        <translation>In dieser Sitzung</translation>
    </message>
    <message>
        <source>%1 (could not be read)</source>
        <translation>%1, nicht gelesen</translation>
    </message>
    <message>
        <source>%1, by itself %2</source>
        <translation>%1, für sich %2</translation>
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
        <source>Rename or close %1</source>
        <translation>%1 umbenennen oder schließen</translation>
    </message>
    <message>
        <source>One tool: one result from all of them</source>
        <translation>Ein Werkzeug: ein Ergebnis aus allen</translation>
    </message>
    <message>
        <source>Each recording keeps its own sensor zero and noise; mass, centre of mass and inertia are shared. A recording that contradicts the others is left out, with a note.</source>
        <translation>Jede Aufnahme behält ihren eigenen Nullpunkt und ihr Rauschen; Masse, Schwerpunkt und Trägheit sind gemeinsam. Eine Aufnahme, die den anderen widerspricht, wird weggelassen; Heft sagt es dann.</translation>
    </message>
    <message>
        <source>&amp;Rename …</source>
        <translation>&amp;Umbenennen …</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Name in this session; the file keeps its own.</source>
        <translation>Name in dieser Sitzung; die Datei behält ihren.</translation>
    </message>
    <message>
        <source>The shape and your reference values apply to all of them. For another tool, start a new session: menu File, New.</source>
        <translation>Die Form und Ihre Vergleichswerte gelten für alle. Für ein anderes Werkzeug beginnen Sie eine neue Sitzung: Menü Datei, Neu.</translation>
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
        <source>residual (grey: noise)</source>
        <translation>Rest (grau: Rauschen)</translation>
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
        <source>Measure between two cursors (Ctrl+click sets the second)</source>
        <translation>Zwischen zwei Linien messen (Strg+Klick setzt die zweite)</translation>
    </message>
    <message>
        <source>Export visible range as CSV</source>
        <translation>Sichtbaren Abschnitt als CSV speichern</translation>
    </message>
    <message>
        <source>Drawing the curves</source>
        <translation>Die Kurven werden gezeichnet</translation>
    </message>
    <message>
        <source>Further channels: joints, pose, speeds</source>
        <translation>Weitere Kanäle: Gelenke, Lage, Geschwindigkeiten</translation>
    </message>
    <message>
        <source>All of these</source>
        <translation>Alle davon</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Picture of the plots, table of the visible segment</source>
        <translation>Bild der Kurven, Tabelle des sichtbaren Abschnitts</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Maximise the plots, or restore them (F11)</source>
        <translation>Kurven maximieren oder zurückholen (F11)</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>Rest</translation>
    </message>
</context>
<context>
    <name>heft::Recovery</name>
    <message>
        <source>The session cannot be saved automatically: %1 Save it elsewhere.</source>
        <translation>Die Sitzung kann nicht automatisch gesichert werden: %1 Speichern Sie sie an einem anderen Ort.</translation>
    </message>
    <message>
        <source>Save as …</source>
        <translation>Speichern unter …</translation>
    </message>
    <message>
        <source>Your last session was not closed. It was saved automatically.</source>
        <translation>Ihre letzte Sitzung wurde nicht geschlossen. Sie wurde automatisch gesichert.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Saved automatically, %1</source>
        <translation>Automatisch gespeichert, %1</translation>
    </message>
    <message>
        <source>The saved session could not be restored; it is now %1. %2</source>
        <translation>Die gesicherte Sitzung konnte nicht wiederhergestellt werden; sie ist jetzt %1. %2</translation>
    </message>
    <message>
        <source>Heft Studio closed during a recording. The data up to that point was saved.</source>
        <translation>Heft Studio endete während einer Aufnahme. Die Daten bis dahin wurden gesichert.</translation>
    </message>
    <message>
        <source>Open the recording</source>
        <translation>Aufnahme öffnen</translation>
    </message>
    <message>
        <source>An older session was restored, saved on %1.</source>
        <translation>Eine ältere Sitzung wurde wiederhergestellt, gespeichert am %1.</translation>
    </message>
    <message>
        <source>A newer one could not be read; it is now %1. %2</source>
        <translation>Eine neuere konnte nicht gelesen werden; sie ist jetzt %1. %2</translation>
    </message>
</context>
<context>
    <name>heft::ResultPanel</name>
    <message>
        <source>What does your tool weigh?</source>
        <translation>Was wiegt Ihr Werkzeug?</translation>
    </message>
    <message>
        <source>Open a recording first, or make one under Record.</source>
        <translation>Öffnen Sie zuerst eine Aufnahme, oder machen Sie eine unter Aufnehmen.</translation>
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
        <source>1 more note in Details.</source>
        <translation>Noch ein Hinweis unter Details.</translation>
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
        <source>All methods</source>
        <translation>Alle Verfahren</translation>
    </message>
    <message>
        <source>Record this motion</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Where the numbers come from</source>
        <translation>Woher die Werte kommen</translation>
    </message>
    <message>
        <source>Compare with a scale or CAD …</source>
        <translation>Mit Waage oder CAD vergleichen …</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>Run reality check</source>
        <translation>Nachsehen, was nicht stimmt</translation>
    </message>
    <message>
        <source>Go to Record</source>
        <translation>Zu „Aufnehmen“</translation>
    </message>
    <message>
        <source>Check the shape</source>
        <translation>Form prüfen</translation>
    </message>
    <message>
        <source>Show the cause</source>
        <translation>Ursache zeigen</translation>
    </message>
    <message>
        <source>Weigh what was picked up</source>
        <translation>Aufgenommenes wiegen</translation>
    </message>
    <message>
        <source>Estimating …</source>
        <translation>Schätzung läuft …</translation>
    </message>
    <message>
        <source>From the motion and the forces in %1.</source>
        <translation>Aus Bewegung und Kräften in %1.</translation>
    </message>
    <message>
        <source>%1 more notes in Details.</source>
        <translation>%1 weitere Hinweise unter Details.</translation>
    </message>
    <message>
        <source>How to improve it</source>
        <translation>Was es verbessert</translation>
    </message>
    <message>
        <source>Compared with your reference values</source>
        <translation>Verglichen mit Ihren Werten</translation>
    </message>
    <message>
        <source>Change reference values …</source>
        <translation>Vergleichswerte ändern …</translation>
    </message>
    <message>
        <source>Find the cause</source>
        <translation>Ursache finden</translation>
    </message>
    <message>
        <source>doubtful – see warnings</source>
        <translation>zweifelhaft, erst prüfen</translation>
    </message>
</context>
<context>
    <name>heft::ResultStep</name>
    <message>
        <source>needs a recording</source>
        <translation>nach der Aufnahme</translation>
    </message>
    <message>
        <source>no estimate yet</source>
        <translation>noch keine Schätzung</translation>
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
    <message>
        <source>no weight yet</source>
        <translation>noch kein Gewicht</translation>
    </message>
    <message>
        <source>What the controller is &amp;set to …</source>
        <translation>Was in der &amp;Steuerung steht …</translation>
    </message>
    <message>
        <source>Something &amp;picked up in this recording</source>
        <translation>In dieser Aufnahme etwas auf&amp;genommen</translation>
    </message>
    <message>
        <source>Something carried: compare &amp;without it …</source>
        <translation>Etwas getragen: &amp;ohne es vergleichen …</translation>
    </message>
    <message>
        <source>estimating …</source>
        <translation>wird geschätzt …</translation>
    </message>
    <message>
        <source>%1, see warnings</source>
        <translation>%1, siehe Warnungen</translation>
    </message>
</context>
<context>
    <name>heft::RigDialog</name>
    <message>
        <source>Robot and sensor</source>
        <translation>Roboter und Sensor</translation>
    </message>
    <message>
        <source>What was recorded?</source>
        <translation>Was wurde aufgenommen?</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>The arm whose joints were recorded</source>
        <translation>Der Arm, dessen Gelenke aufgenommen wurden</translation>
    </message>
    <message>
        <source>Franka Panda</source>
        <translation>Franka Panda</translation>
    </message>
    <message>
        <source>Another arm (URDF)</source>
        <translation>Ein anderer Arm (URDF)</translation>
    </message>
    <message>
        <source>None: poses only</source>
        <translation>Keiner: nur Posen</translation>
    </message>
    <message>
        <source>Description of the robot (URDF)</source>
        <translation>Beschreibung des Roboters (URDF)</translation>
    </message>
    <message>
        <source>Choose the description of the robot</source>
        <translation>Beschreibung des Roboters wählen</translation>
    </message>
    <message>
        <source>Its URDF</source>
        <translation>Sein URDF</translation>
    </message>
    <message>
        <source>The link of the arm that carries the sensor</source>
        <translation>Das Glied des Arms, das den Sensor trägt</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> °</source>
        <translation> °</translation>
    </message>
    <message>
        <source> m/s²</source>
        <translation> m/s²</translation>
    </message>
    <message>
        <source>Which way gravity pulls at its base</source>
        <translation>Wohin die Schwerkraft an seinem Sockel zieht</translation>
    </message>
    <message>
        <source>Choose the description of the robot that was recorded</source>
        <translation>Beschreibung des aufgenommenen Roboters wählen</translation>
    </message>
    <message>
        <source>Robot descriptions (*.urdf);;All files (*)</source>
        <translation>Roboterbeschreibungen (*.urdf);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Choose the URDF of the arm, or another robot.</source>
        <translation>Wählen Sie das URDF des Arms oder einen anderen Roboter.</translation>
    </message>
    <message>
        <source>Errors here affect all results. If you are unsure about the mounting, leave it: the reality check can detect it.</source>
        <translation>Fehler hier wirken auf alle Werte. Wenn Sie beim Anbau nicht sicher sind, lassen Sie ihn: Die Realitätsprüfung kann ihn finden.</translation>
    </message>
    <message>
        <source>The file with the robot’s joints and links</source>
        <translation>Die Datei mit Gelenken und Gliedern des Roboters</translation>
    </message>
    <message>
        <source>Sensor mounted on</source>
        <translation>Sensor sitzt an</translation>
    </message>
    <message>
        <source>Sensor’s origin from the link, %1</source>
        <translation>Ursprung des Sensors vom Glied aus, %1</translation>
    </message>
    <message>
        <source>Sensor’s rotation from the link, %1 (roll, then pitch, then yaw about fixed axes)</source>
        <translation>Drehung des Sensors gegen das Glied, %1 (erst Rollen, dann Nicken, dann Gieren um feste Achsen)</translation>
    </message>
    <message>
        <source>Gravity along the base’s %1</source>
        <translation>Schwerkraft entlang %1 des Sockels</translation>
    </message>
    <message>
        <source>Robot mounting</source>
        <translation>Aufstellung</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>aufrecht</translation>
    </message>
    <message>
        <source>hanging from the ceiling</source>
        <translation>hängend an der Decke</translation>
    </message>
    <message>
        <source>other</source>
        <translation>anders</translation>
    </message>
    <message>
        <source>Sensor model</source>
        <translation>Sensormodell</translation>
    </message>
    <message>
        <source>For your own reference only</source>
        <translation>Nur für Ihre Unterlagen</translation>
    </message>
    <message>
        <source>Saved to %1 beside the recording; other entries are kept.</source>
        <translation>Wird in %1 neben der Aufnahme gespeichert; andere Einträge bleiben.</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Übernehmen</translation>
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
        <source>Centre of mass</source>
        <translation>Schwerpunkt</translation>
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
        <source>No robot in this recording: only the sensor is shown</source>
        <translation>Diese Aufnahme hat keinen Roboter: Nur der Sensor wird gezeigt</translation>
    </message>
    <message>
        <source>No position in this recording: the sensor only rotates</source>
        <translation>Diese Aufnahme hat keine Position: Der Sensor dreht sich auf der Stelle</translation>
    </message>
    <message>
        <source>sensor, tool side</source>
        <translation>Sensor, Werkzeugseite</translation>
    </message>
    <message>
        <source>not known from this motion</source>
        <translation>aus dieser Bewegung nicht bekannt</translation>
    </message>
    <message>
        <source>the shape is mounted here</source>
        <translation>hier sitzt die Form</translation>
    </message>
    <message>
        <source>No joint angles recorded: a Panda that reaches these poses is shown</source>
        <translation>Keine Gelenkwinkel aufgenommen: gezeigt wird ein Panda, der diese Lagen erreicht</translation>
    </message>
</context>
<context>
    <name>heft::RoomRow</name>
    <message>
        <source>Choose a room …</source>
        <translation>Raum wählen …</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the room</source>
        <translation>Raum entfernen</translation>
    </message>
    <message>
        <source>A file with walls, tables, boxes and meshes (heft.room/1).</source>
        <translation>Eine Datei mit Wänden, Tischen, Quadern und Netzen (heft.room/1).</translation>
    </message>
    <message>
        <source>From touches</source>
        <translation>Aus Berührungen</translation>
    </message>
    <message>
        <source>Walls and tables that the tool was pressed against in this recording, by the tool’s shape and the direction of what presses back.</source>
        <translation>Wände und Tische, gegen die das Werkzeug in dieser Aufnahme gedrückt wurde: aus der Form des Werkzeugs und der Richtung des Gegendrucks.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n obstacle(s); everything stays at least %2 mm away.</source>
        <translation>
            <numerusform>%1: %n Hindernis; nichts kommt näher als %2 mm.</numerusform>
            <numerusform>%1: %n Hindernisse; nichts kommt näher als %2 mm.</numerusform>
        </translation>
    </message>
    <message>
        <source>Obstacles</source>
        <translation>Hindernisse</translation>
    </message>
    <message>
        <source>Walls and tables are not known: suggested motions only keep the arm clear of itself and its tool.</source>
        <translation>Wände und Tische sind nicht bekannt: Was der Trainer vorschlägt, hält den Arm nur von sich selbst und seinem Werkzeug fern.</translation>
    </message>
</context>
<context>
    <name>heft::ScriptRunner</name>
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
        <source>%1 already exists and was not overwritten.</source>
        <translation>%1 gibt es schon und wurde nicht ersetzt.</translation>
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
        <source>robot needs an open recording.</source>
        <translation>robot braucht eine offene Aufnahme.</translation>
    </message>
    <message>
        <source>The open recording has no channel %1.</source>
        <translation>Die offene Aufnahme hat keinen Kanal %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has none of the forms: %2</source>
        <translation>„%1“ passt zu keiner der Formen: %2</translation>
    </message>
    <message>
        <source>Unknown command &quot;%1&quot;; see heft-studio --help.</source>
        <translation>Unbekannter Befehl „%1“; siehe heft-studio --help.</translation>
    </message>
</context>
<context>
    <name>heft::ShapePanel</name>
    <message>
        <source>The tool’s CAD mesh</source>
        <translation>Das CAD-Netz des Werkzeugs</translation>
    </message>
    <message>
        <source>Meshes (*.stl *.obj *.ply *.dae *.glb *.gltf *.3mf *.off *.fbx);;All files (*)</source>
        <translation>Netze (*.stl *.obj *.ply *.dae *.glb *.gltf *.3mf *.off *.fbx);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>shape: %1</source>
        <translation>Form: %1</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>What does your tool look like?</source>
        <translation>Wie sieht Ihr Werkzeug aus?</translation>
    </message>
    <message>
        <source>Choose the closest shape. It doesn’t have to be exact.</source>
        <translation>Wählen Sie das ähnlichste Bild. Es muss nicht genau stimmen.</translation>
    </message>
    <message>
        <source>The shape fills in the mass distribution where the motion doesn’t determine it. The result shows how much each value depends on it.</source>
        <translation>Eine Form sagt Heft, wie das Gewicht verteilt ist, wo die Bewegung es nicht gezeigt hat. Das Ergebnis sagt, wie viel jede Zahl ihr verdankt.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Use this shape</source>
        <translation>Diese Form verwenden</translation>
    </message>
    <message>
        <source>I don’t know</source>
        <translation>Weiß ich nicht</translation>
    </message>
    <message>
        <source>Use the motion only</source>
        <translation>nur die Bewegung zählt</translation>
    </message>
    <message>
        <source>unit of the mesh</source>
        <translation>Einheit des Netzes</translation>
    </message>
    <message>
        <source>thin shell</source>
        <translation>dünne Schale</translation>
    </message>
    <message>
        <source>move the tool</source>
        <translation>Werkzeug verschieben</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Fingers</source>
        <translation>Finger</translation>
    </message>
    <message>
        <source>add a part</source>
        <translation>Teil hinzufügen</translation>
    </message>
    <message>
        <source>Size of part %1</source>
        <translation>Größe von Teil %1</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>How sure are you of these sizes?</source>
        <translation>Wie sicher sind Sie bei diesen Maßen?</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>Grob</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Gut</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Genau</translation>
    </message>
    <message>
        <source>how sure the sizes are</source>
        <translation>wie sicher die Maße sind</translation>
    </message>
    <message>
        <source>Part %1, if known</source>
        <translation>Teil %1, falls bekannt</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>solid</source>
        <translation>massiv</translation>
    </message>
    <message>
        <source>hollow</source>
        <translation>hohl</translation>
    </message>
    <message>
        <source>wall thickness</source>
        <translation>Wandstärke</translation>
    </message>
    <message>
        <source>not weighed</source>
        <translation>nicht gewogen</translation>
    </message>
    <message>
        <source>tilt the tool</source>
        <translation>Werkzeug neigen</translation>
    </message>
    <message>
        <source>Position: centred on the sensor, not tilted</source>
        <translation>Wo es sitzt: mitten auf dem Sensor, gerade</translation>
    </message>
    <message>
        <source>, tilted by %1°</source>
        <translation>, geneigt um %1°</translation>
    </message>
    <message>
        <source>Choose a shape to place it here</source>
        <translation>Wählen Sie ein Bild, dann steht das Werkzeug hier</translation>
    </message>
    <message>
        <source>Drag a white handle to change the size</source>
        <translation>Ziehen Sie an einem weißen Griff, um die Größe zu ändern</translation>
    </message>
    <message>
        <source>Drag an arrow to move along an axis, the centre to move freely</source>
        <translation>Ziehen Sie an einem Pfeil, um das Werkzeug zu verschieben, an der Mitte, um es frei zu verschieben</translation>
    </message>
    <message>
        <source>Drag a ring to tilt the tool</source>
        <translation>Ziehen Sie an einem Ring, um das Werkzeug zu neigen</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Lengths in mm from the sensor’s tool side · Ctrl+Z to undo</source>
        <translation>Längen in mm, von der Werkzeugseite des Sensors aus · Strg+Z nimmt zurück</translation>
    </message>
    <message>
        <source>Tool from a CA&amp;D mesh …</source>
        <translation>Werkzeug aus CA&amp;D-Netz …</translation>
    </message>
    <message>
        <source>shape not known</source>
        <translation>Form unbekannt</translation>
    </message>
    <message>
        <source>change a length</source>
        <translation>Länge ändern</translation>
    </message>
    <message>
        <source>material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Choose a CAD file …</source>
        <translation>CAD-Datei wählen …</translation>
    </message>
    <message>
        <source>choose a CAD file</source>
        <translation>CAD-Datei wählen</translation>
    </message>
    <message>
        <source>Continue without a shape</source>
        <translation>Ohne Form weiter</translation>
    </message>
    <message>
        <source>I don’t know, continue</source>
        <translation>Weiß ich nicht, weiter</translation>
    </message>
    <message>
        <source>Parts joined to each other</source>
        <translation>Teile, miteinander verbunden</translation>
    </message>
    <message>
        <source>remove a part</source>
        <translation>Teil entfernen</translation>
    </message>
    <message>
        <source>Total weight, from a scale</source>
        <translation>Gesamtgewicht, von einer Waage</translation>
    </message>
    <message>
        <source>Total weight</source>
        <translation>Gesamtgewicht</translation>
    </message>
    <message>
        <source>Position: %1, %2, %3 mm</source>
        <translation>Lage: %1, %2, %3 mm</translation>
    </message>
    <message>
        <source>“%1” is not a valid length. Enter a number from %2 to %3 mm.</source>
        <translation>„%1“ ist keine gültige Länge. Geben Sie eine Zahl von %2 bis %3 mm ein.</translation>
    </message>
    <message>
        <source>Until a file is chosen, the result uses: %1.</source>
        <translation>Bis eine Datei gewählt ist, gilt im Ergebnis: %1.</translation>
    </message>
    <message>
        <source>contradicts the data, left out</source>
        <translation>widerspricht den Daten, weggelassen</translation>
    </message>
</context>
<context>
    <name>heft::SourceForm</name>
    <message>
        <source>Where does the force/torque data come from?</source>
        <translation>Wer misst Kraft und Drehmoment?</translation>
    </message>
    <message>
        <source>Net F/T sensor</source>
        <translation>Net-F/T-Sensor</translation>
    </message>
    <message>
        <source>ATI, Schunk</source>
        <translation>ATI, Schunk</translation>
    </message>
    <message>
        <source>ROS, Foxglove bridge</source>
        <translation>ROS, Foxglove-Brücke</translation>
    </message>
    <message>
        <source>joints and wrench</source>
        <translation>Gelenke und Kräfte</translation>
    </message>
    <message>
        <source>ROS, rosbridge</source>
        <translation>ROS, rosbridge</translation>
    </message>
    <message>
        <source>JSON over UDP</source>
        <translation>JSON über UDP</translation>
    </message>
    <message>
        <source>Address of the sensor, for instance 192.168.1.1</source>
        <translation>Adresse des Sensors, zum Beispiel 192.168.1.1</translation>
    </message>
    <message>
        <source>Foxglove bridge address (default: localhost:8765)</source>
        <translation>Adresse der Foxglove-Brücke; leer: localhost:8765</translation>
    </message>
    <message>
        <source>Computer and port of foxglove_bridge</source>
        <translation>Rechner und Port von foxglove_bridge</translation>
    </message>
    <message>
        <source>Computer and port of rosbridge_server</source>
        <translation>Rechner und Port von rosbridge_server</translation>
    </message>
    <message>
        <source>UDP port (default: 9870)</source>
        <translation>Port, an den Ihr Programm sendet; leer: 9870</translation>
    </message>
    <message>
        <source>Any recording that Heft opens</source>
        <translation>Jede Aufzeichnung, die Heft öffnet</translation>
    </message>
    <message>
        <source>Choose a recording</source>
        <translation>Aufzeichnung wählen</translation>
    </message>
    <message>
        <source>Where do the joint angles come from?</source>
        <translation>Wer sagt, wie der Arm steht?</translation>
    </message>
    <message>
        <source>Foxglove</source>
        <translation>Foxglove</translation>
    </message>
    <message>
        <source>rosbridge</source>
        <translation>rosbridge</translation>
    </message>
    <message>
        <source>JSON, UDP</source>
        <translation>JSON, UDP</translation>
    </message>
    <message>
        <source>Setup file (NAME.meta.json), optional</source>
        <translation>Aufbaudatei (NAME.meta.json), falls vorhanden</translation>
    </message>
    <message>
        <source>Choose a setup file</source>
        <translation>Aufbaudatei wählen</translation>
    </message>
    <message>
        <source>Setup files (*.json)</source>
        <translation>Aufbaudateien (*.json)</translation>
    </message>
    <message>
        <source>Universal Robots</source>
        <translation>Universal Robots</translation>
    </message>
    <message>
        <source>Address of the robot, for instance 192.168.0.10</source>
        <translation>Adresse des Roboters, zum Beispiel 192.168.0.10</translation>
    </message>
    <message>
        <source>UR</source>
        <translation>UR</translation>
    </message>
    <message>
        <source>Where is the sensor’s measuring point?</source>
        <translation>Wo ist der Messpunkt des Sensors?</translation>
    </message>
    <message>
        <source>At the flange</source>
        <translation>Am Flansch</translation>
    </message>
    <message>
        <source>Below it</source>
        <translation>Darunter</translation>
    </message>
    <message>
        <source>Not sure</source>
        <translation>Weiß nicht</translation>
    </message>
    <message>
        <source>Distance along the flange’s axis</source>
        <translation>Abstand entlang der Flanschachse</translation>
    </message>
    <message>
        <source>One JSON object per datagram: time [s], q1 … q7 [rad], fx fy fz [N], tx ty tz [N m]. Only from this computer.</source>
        <translation>Datagramme mit je einem JSON-Objekt: time [s], q1 … q7 [rad], fx fy fz [N], tx ty tz [N m]. Nur von diesem Rechner.</translation>
    </message>
    <message>
        <source>Custom program</source>
        <translation>Eigenes Programm</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>replayed in real time</source>
        <translation>in Echtzeit abgespielt</translation>
    </message>
    <message>
        <source>As shown on the sensor’s web page. Heft only reads its data.</source>
        <translation>Wie auf der Webseite des Sensors. Heft liest nur seine Daten.</translation>
    </message>
    <message>
        <source>rosbridge address (default: localhost:9090)</source>
        <translation>Adresse von rosbridge (sonst localhost:9090)</translation>
    </message>
    <message>
        <source>Recording to replay</source>
        <translation>Aufnahme zum Abspielen</translation>
    </message>
    <message>
        <source>States the robot, the sensor’s mounting and the sign of its forces</source>
        <translation>Sagt, welcher Roboter es ist, wie der Sensor sitzt und welches Vorzeichen seine Kräfte haben</translation>
    </message>
    <message>
        <source>Enter the sensor’s address.</source>
        <translation>Geben Sie die Adresse des Sensors ein.</translation>
    </message>
    <message>
        <source>Choose a recording to replay.</source>
        <translation>Wählen Sie eine Aufnahme zum Abspielen.</translation>
    </message>
    <message>
        <source>Standing poses cannot be replayed as a motion.</source>
        <translation>Stehende Posen lassen sich nicht als Bewegung abspielen.</translation>
    </message>
    <message>
        <source>A Universal Robots e-Series with its own force sensor. Heft only reads from it.</source>
        <translation>Eine e-Series von Universal Robots mit eigenem Kraftsensor. Heft liest nur und schreibt nichts in die Steuerung.</translation>
    </message>
    <message>
        <source>Enter the robot’s address.</source>
        <translation>Geben Sie die Adresse des Roboters ein.</translation>
    </message>
    <message>
        <source>Without one, the recording’s own is used.</source>
        <translation>Ohne eine gilt die der Aufnahme.</translation>
    </message>
    <message>
        <source>Without one, Heft assumes a Franka Panda, and asks:</source>
        <translation>Ohne eine nimmt Heft einen Franka Panda an und fragt:</translation>
    </message>
    <message>
        <source>Heft assumes the flange’s axes for now and asks again after the recording.</source>
        <translation>Heft nimmt jetzt die Achsen des Flansches an und fragt nach der Aufnahme noch einmal.</translation>
    </message>
    <message>
        <source>Heft assumes the flange’s axes; a rotated sensor needs a setup file.</source>
        <translation>Heft nimmt die Achsen des Flansches an; ein verdrehter Sensor braucht eine Aufbaudatei.</translation>
    </message>
    <message>
        <source>Enter the sensor’s measuring point, or choose a setup file.</source>
        <translation>Geben Sie den Messpunkt des Sensors ein, oder wählen Sie eine Aufbaudatei.</translation>
    </message>
</context>
<context>
    <name>heft::SourcesDialog</name>
    <message>
        <source>Force and torque</source>
        <translation>Kraft und Moment</translation>
    </message>
    <message>
        <source>N and N m</source>
        <translation>N und N m</translation>
    </message>
    <message>
        <source>N and N mm</source>
        <translation>N und N mm</translation>
    </message>
    <message>
        <source>Joint angles</source>
        <translation>Gelenkwinkel</translation>
    </message>
    <message>
        <source>radians</source>
        <translation>Bogenmaß</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>Joint speeds</source>
        <translation>Gelenkgeschwindigkeiten</translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation>rad/s</translation>
    </message>
    <message>
        <source>degrees/s</source>
        <translation>Grad/s</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientierung</translation>
    </message>
    <message>
        <source>Of the sensor or the flange, as a quaternion; needed without joint angles</source>
        <translation>Des Sensors oder des Flanschs, als Quaternion; ohne Gelenkwinkel nötig</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Of the sensor or the flange</source>
        <translation>Des Sensors oder des Flanschs</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>The column or dataset that holds the time of each sample</source>
        <translation>Die Spalte oder der Datensatz mit der Zeit jedes Messwerts</translation>
    </message>
    <message>
        <source>unit as found</source>
        <translation>wie erkannt</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>µs</source>
        <translation>µs</translation>
    </message>
    <message>
        <source>ns</source>
        <translation>ns</translation>
    </message>
    <message>
        <source>Unit of: %1</source>
        <translation>Einheit von: %1</translation>
    </message>
    <message>
        <source>the sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>the flange</source>
        <translation>Flansch</translation>
    </message>
    <message>
        <source>Wrench time offset</source>
        <translation>Zur Zeit der Kräfte dazu</translation>
    </message>
    <message>
        <source>Seconds added to the times of force and torque</source>
        <translation>Sekunden, die zu den Zeiten von Kraft und Moment kommen</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Add another file…</source>
        <translation>Eine Datei dazunehmen …</translation>
    </message>
    <message>
        <source>Choose columns individually</source>
        <translation>Jede Spalte einzeln wählen</translation>
    </message>
    <message>
        <source>Column for %1</source>
        <translation>Spalte für %1</translation>
    </message>
    <message>
        <source>Add a file recorded with it</source>
        <translation>Eine Datei dazunehmen</translation>
    </message>
    <message>
        <source>This can be read.</source>
        <translation>So lässt es sich lesen.</translation>
    </message>
    <message>
        <source>as above</source>
        <translation>wie oben</translation>
    </message>
    <message>
        <source>times %1</source>
        <translation>mal %1</translation>
    </message>
    <message>
        <source>%1 could not be removed: check that the folder may be written to.</source>
        <translation>%1 ließ sich nicht entfernen: Prüfen Sie, ob in den Ordner geschrieben werden darf.</translation>
    </message>
    <message>
        <source>Columns and units</source>
        <translation>Spalten und Einheiten</translation>
    </message>
    <message>
        <source>Which column is which?</source>
        <translation>Welche Spalte ist was?</translation>
    </message>
    <message>
        <source>Heft assigned the columns of %1 by type and name. Correct anything that is wrong.</source>
        <translation>Heft hat die Spalten von %1 nach Typ und Namen zugeordnet. Berichtigen Sie, was falsch ist.</translation>
    </message>
    <message>
        <source>As measured by the sensor at the wrist</source>
        <translation>Wie der Sensor am Handgelenk sie gemessen hat</translation>
    </message>
    <message>
        <source>With joint angles, no pose is needed</source>
        <translation>Mit Gelenkwinkeln ist keine Pose nötig</translation>
    </message>
    <message>
        <source>Only with joint angles; optional</source>
        <translation>Nur mit Gelenkwinkeln; kann fehlen</translation>
    </message>
    <message>
        <source>Saved to %1 beside the recording; also used by the command line.</source>
        <translation>Wird in %1 neben der Aufnahme gespeichert; auch die Befehlszeile benutzt es.</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Unit used in the file</source>
        <translation>Einheit in der Datei</translation>
    </message>
    <message>
        <source>Poses describe</source>
        <translation>Posen beschreiben</translation>
    </message>
    <message>
        <source>The sensor’s poses are derived from the flange’s by its mounting</source>
        <translation>Die Posen des Sensors folgen aus denen des Flanschs und seinem Anbau</translation>
    </message>
    <message>
        <source>For force and torque on another clock, where Heft cannot determine the offset</source>
        <translation>Für Kraft und Moment auf einer anderen Uhr, wenn Heft den Versatz nicht bestimmen kann</translation>
    </message>
    <message>
        <source>For instance the sensor’s own log beside the robot’s</source>
        <translation>Zum Beispiel die Aufzeichnung des Sensors neben der des Roboters</translation>
    </message>
    <message>
        <source>Source of %1</source>
        <translation>Quelle von %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Wird geprüft …</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>automatic: %1</source>
        <translation>automatisch: %1</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nichts gefunden</translation>
    </message>
</context>
<context>
    <name>heft::StatusBar</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Stopping …</source>
        <translation>Hält an …</translation>
    </message>
    <message>
        <source>Stop this task</source>
        <translation>Diese Aufgabe anhalten</translation>
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
    <name>heft::Stepper</name>
    <message>
        <source>%1: less</source>
        <translation>%1: weniger</translation>
    </message>
    <message>
        <source>%1: more</source>
        <translation>%1: mehr</translation>
    </message>
    <message>
        <source>%1 in %2. Arrow keys change it, Page Up and Down by ten.</source>
        <translation>%1 in %2. Pfeiltasten ändern den Wert, Bild auf und ab um zehn.</translation>
    </message>
    <message>
        <source>between %1 and %2 %3</source>
        <translation>zwischen %1 und %2 %3</translation>
    </message>
    <message>
        <source>%1 must be %2.</source>
        <translation>%1 muss %2 liegen.</translation>
    </message>
    <message>
        <source>“%1” is not a number: %2 must be %3.</source>
        <translation>„%1“ ist keine Zahl: %2 muss %3 liegen.</translation>
    </message>
</context>
<context>
    <name>heft::SubstanceForm</name>
    <message>
        <source>Weight of this part</source>
        <translation>Gewicht dieses Teils</translation>
    </message>
    <message>
        <source>Weight from a scale, if known</source>
        <translation>Gewicht von der Waage, falls bekannt</translation>
    </message>
    <message>
        <source>not weighed</source>
        <translation>nicht gewogen</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Massiv</translation>
    </message>
    <message>
        <source>Thin shell</source>
        <translation>Dünne Schale</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>Hohl</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>Wandstärke</translation>
    </message>
    <message>
        <source>Material, if known</source>
        <translation>Material, falls bekannt</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>%1 kg/m³</source>
        <translation>%1 kg/m³</translation>
    </message>
    <message>
        <source>estimated</source>
        <translation>wird ermittelt</translation>
    </message>
    <message>
        <source>Interior</source>
        <translation>Innen</translation>
    </message>
    <message>
        <source>Only if the whole tool is made of it; optional.</source>
        <translation>Nur wenn das ganze Werkzeug daraus ist; kann offen bleiben.</translation>
    </message>
    <message>
        <source>In %1, this would weigh %2.</source>
        <translation>Aus %1 wiegt das %2.</translation>
    </message>
</context>
<context>
    <name>heft::TouchedWalls</name>
    <message>
        <source>Open a recording in which the tool is pressed against walls and tables first.</source>
        <translation>Öffnen Sie zuerst eine Aufnahme, in der das Werkzeug gegen Wände und Tische gedrückt wird.</translation>
    </message>
    <message>
        <source>The payload is needed to tell a touch from the tool’s weight; there is none yet.</source>
        <translation>Um eine Berührung vom Gewicht des Werkzeugs zu trennen, wird die Last gebraucht; sie ist noch nicht bekannt.</translation>
    </message>
    <message>
        <source>State the tool’s shape first (step Shape): a wall begins where the tool ends.</source>
        <translation>Geben Sie zuerst die Form des Werkzeugs an (Schritt Form): Eine Wand beginnt dort, wo das Werkzeug endet.</translation>
    </message>
    <message>
        <source>Looking for walls that were touched</source>
        <translation>Berührte Wände werden gesucht</translation>
    </message>
    <message>
        <source>Walls that were touched</source>
        <translation>Berührte Wände</translation>
    </message>
    <message>
        <source>Found: %1. Saved as %2.</source>
        <translation>Gefunden: %1. Gespeichert als %2.</translation>
    </message>
</context>
<context>
    <name>heft::Tour</name>
    <message>
        <source>Everything begins with a recording: the arm moved with its tool while the sensor measured. In this sample a hose pulls at the tool, and Heft does not know that. Press the space bar to see the arm move.</source>
        <translation>Alles beginnt mit einer Aufnahme: Der Arm bewegte sich mit seinem Werkzeug, der Sensor maß. In diesem Beispiel zieht ein Schlauch am Werkzeug, und niemand hat es Heft gesagt. Die Leertaste lässt den Arm laufen.</translation>
    </message>
    <message>
        <source>If you know roughly what the tool looks like, describe it here: it helps where the motion shows too little. “I don’t know” is a fine answer, and right for now.</source>
        <translation>Wenn Sie ungefähr wissen, wie das Werkzeug aussieht, sagen Sie es hier: Es hilft, wo die Bewegung zu wenig zeigt. „Weiß ich nicht“ ist eine gute Antwort, und für jetzt die richtige.</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Rundgang beenden</translation>
    </message>
    <message>
        <source>Tour, %1 of 6: %2</source>
        <translation>Rundgang, %1 von 6: %2</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Here Heft names the cause and draws it on the arm. Press “Apply this correction”, look at the curves below the arm, then at step 4: the number has come close to the truth.</source>
        <translation>Hier sagt Heft, was es ist, und zeichnet es an den Arm. Wenden Sie die Korrektur an, sehen Sie auf die Kurven unter dem Arm und dann auf Schritt 4: Der Wert ist nahe an der Wahrheit.</translation>
    </message>
    <message>
        <source>Only segments without contact are used. Heft has marked them; everything is free here. In your own recordings you can paint over marks that are wrong.</source>
        <translation>Nur Abschnitte ohne Kontakt werden benutzt. Heft hat sie markiert; hier ist alles frei. In eigenen Aufnahmen übermalen Sie falsche Marken.</translation>
    </message>
    <message>
        <source>The weight, and how certain it is. The triangles are warnings: something other than a rigid tool affects the readings. The tool of this sample really weighs 0.800 kg.</source>
        <translation>Das Gewicht, und wie sicher es ist. Die Dreiecke warnen: Etwas anderes als ein starres Werkzeug wirkt auf die Messwerte. In Wahrheit wiegt das Werkzeug dieses Beispiels 0,800 kg.</translation>
    </message>
    <message>
        <source>Choose your controller, look at the file, save it. That is all. Continue with a recording of your own, with the virtual arm, or with an exercise from the menu Practice.</source>
        <translation>Wählen Sie Ihre Steuerung, sehen Sie die Datei an, speichern Sie sie. Das ist alles. Weiter geht es mit einer eigenen Aufnahme, mit dem virtuellen Arm oder mit einer Übung aus dem Menü Üben.</translation>
    </message>
</context>
<context>
    <name>heft::ViewTools</name>
    <message>
        <source>Show the whole arm (F)</source>
        <translation>Den ganzen Arm zeigen (F)</translation>
    </message>
    <message>
        <source>Zoom to the tool (T)</source>
        <translation>Nah ans Werkzeug (T)</translation>
    </message>
    <message>
        <source>View direction</source>
        <translation>Blickrichtung</translation>
    </message>
    <message>
        <source>Choose what is shown</source>
        <translation>Wählen, was gezeigt wird</translation>
    </message>
    <message>
        <source>Maximise the 3D view, or restore it (Shift+F11)</source>
        <translation>3D-Ansicht maximieren oder zurückholen (Umschalt+F11)</translation>
    </message>
    <message>
        <source>Save a picture of this view</source>
        <translation>Bild dieser Ansicht speichern</translation>
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
        <source>Tool</source>
        <translation>Werkzeug</translation>
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
</context>
<context>
    <name>heft::Viewport</name>
    <message>
        <source>The 3D view needs OpenGL, which this computer does not offer. Everything else works without it.</source>
        <translation>Die 3D-Ansicht braucht OpenGL, das dieser Rechner nicht bietet. Alles andere geht auch ohne.</translation>
    </message>
</context>
<context>
    <name>heft::WeightField</name>
    <message>
        <source>Unit of the weight</source>
        <translation>Einheit des Gewichts</translation>
    </message>
    <message>
        <source>“%1” is not a weight. Enter e.g. 0.8 kg or 800 g, or leave it blank.</source>
        <translation>„%1“ ist kein Gewicht: Schreiben Sie eine Zahl wie 0,8 kg oder 800 g, oder lassen Sie das Feld leer.</translation>
    </message>
    <message>
        <source>What the scale shows for everything behind the sensor; optional.</source>
        <translation>Was die Waage für alles hinter dem Sensor zeigt; kann offen bleiben.</translation>
    </message>
</context>
<context>
    <name>heft::WhatIfKnobs</name>
    <message>
        <source>Open a recording first.</source>
        <translation>Öffnen Sie zuerst eine Aufnahme.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>This motion shows it from %1 on.</source>
        <translation>Diese Bewegung zeigt es ab %1.</translation>
    </message>
    <message>
        <source>This motion does not show it.</source>
        <translation>Diese Bewegung zeigt es nicht.</translation>
    </message>
    <message>
        <source>%1 goes from 0 to %2.</source>
        <translation>%1 geht von 0 bis %2.</translation>
    </message>
    <message>
        <source>whatif needs an open recording.</source>
        <translation>whatif braucht eine offene Aufnahme.</translation>
    </message>
    <message>
        <source>There is no slider %1 on this recording.</source>
        <translation>Für diese Aufnahme gibt es keinen Regler %1.</translation>
    </message>
    <message>
        <source>Preparing the sliders …</source>
        <translation>Die Regler werden vorbereitet …</translation>
    </message>
    <message>
        <source>Preparing the sliders</source>
        <translation>Regler werden vorbereitet</translation>
    </message>
</context>
<context>
    <name>heft::WhatIfPane</name>
    <message>
        <source>Centre %1</source>
        <translation>Schwerpunkt %1</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>What if …?</source>
        <translation>Was wäre, wenn …?</translation>
    </message>
    <message>
        <source>Back to the reality check</source>
        <translation>Zurück zur Realitätsprüfung</translation>
    </message>
    <message>
        <source>was %1</source>
        <translation>vorher %1</translation>
    </message>
    <message>
        <source>No fault is on: this is the recording as it is.</source>
        <translation>Kein Fehler ist an: So ist die Aufnahme.</translation>
    </message>
    <message>
        <source>Nothing else looks like it: “%1” explains %2 % of it at most.</source>
        <translation>Nichts anderes sieht so aus: „%1“ erklärt davon höchstens %2 %.</translation>
    </message>
    <message>
        <source>It looks like “%1” %2: that explains %3 % of it. To decide: %4</source>
        <translation>Es sieht aus wie „%1“ %2: Das erklärt %3 % davon. Zum Entscheiden: %4</translation>
    </message>
    <message>
        <source>Not visible in this motion, and the numbers are wrong all the same.</source>
        <translation>In dieser Bewegung nicht zu sehen, und die Zahlen sind trotzdem falsch.</translation>
    </message>
    <message>
        <source>Not visible in this motion, and harmless.</source>
        <translation>In dieser Bewegung nicht zu sehen und harmlos.</translation>
    </message>
    <message>
        <source>Residual force [%1]</source>
        <translation>Rest, Kraft [%1]</translation>
    </message>
    <message>
        <source>Residual torque [%1]</source>
        <translation>Rest, Moment [%1]</translation>
    </message>
    <message>
        <source>Visible: the residual is %1 N and %2, and %3 N and %4 without it.</source>
        <translation>Zu sehen: Der Rest beträgt %1 N und %2, ohne den Fehler %3 N und %4.</translation>
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
    <message>
        <source>rename “%1”</source>
        <translation>„%1“ umbenennen</translation>
    </message>
    <message>
        <source>close “%1”</source>
        <translation>„%1“ schließen</translation>
    </message>
    <message>
        <source>one result for all recordings</source>
        <translation>ein Ergebnis für alle Aufnahmen</translation>
    </message>
    <message>
        <source>a result for each recording</source>
        <translation>ein Ergebnis für jede Aufnahme</translation>
    </message>
    <message>
        <source>remove a mark</source>
        <translation>Marke entfernen</translation>
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
        <source>Torque</source>
        <translation>Moment</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Show the whole recording</source>
        <translation>Die ganze Aufnahme zeigen</translation>
    </message>
    <message>
        <source>Scale to the free parts</source>
        <translation>Auf die freien Teile skalieren</translation>
    </message>
    <message>
        <source>A contact may go out of the picture, so that the rest can be seen</source>
        <translation>Ein Kontakt darf aus dem Bild laufen, damit man den Rest sieht</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Scale the values to the curves</source>
        <translation>Werte an die Kurven anpassen</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>Rest</translation>
    </message>
</context>
</TS>
