<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>CauseCard</name>
    <message numerus="yes">
        <source>%n false alarm(s) in %1 simulated clean runs.</source>
        <translation>
            <numerusform>%n false alarm in %1 simulated clean runs.</numerusform>
            <numerusform>%n false alarms in %1 simulated clean runs.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Joining</name>
    <message numerus="yes">
        <source>Joint result from %n recordings: %1.</source>
        <translation>
            <numerusform>Joint result from %n recording: %1.</numerusform>
            <numerusform>Joint result from %n recordings: %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>LiveWords</name>
    <message numerus="yes">
        <source>%n of at least 6 poses can be used.</source>
        <translation>
            <numerusform>%n of at least 6 poses can be used.</numerusform>
            <numerusform>%n of at least 6 poses can be used.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) lost</source>
        <translation>
            <numerusform>%n sample lost</numerusform>
            <numerusform>%n samples lost</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n late</source>
        <translation>
            <numerusform>%n late</numerusform>
            <numerusform>%n late</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unreadable</source>
        <translation>
            <numerusform>%n unreadable</numerusform>
            <numerusform>%n unreadable</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reported as faulty by the device</source>
        <translation>
            <numerusform>%n reported as faulty by the device</numerusform>
            <numerusform>%n reported as faulty by the device</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>connection lost %n time(s)</source>
        <translation>
            <numerusform>connection lost %n time</numerusform>
            <numerusform>connection lost %n times</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MarkText</name>
    <message numerus="yes">
        <source>Only free segments are used. Please review %n suggestion(s).</source>
        <translation>
            <numerusform>Only free segments are used. Please review %n suggestion.</numerusform>
            <numerusform>Only free segments are used. Please review %n suggestions.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RealityPage</name>
    <message numerus="yes">
        <source>%n correction(s) applied</source>
        <translation>
            <numerusform>%n correction applied</numerusform>
            <numerusform>%n corrections applied</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n cause(s) found</source>
        <translation>
            <numerusform>One cause found</numerusform>
            <numerusform>%n causes found</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n findings are still open</source>
        <translation>
            <numerusform>One finding is still open</numerusform>
            <numerusform>%n findings are still open</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n cause(s) found, </source>
        <translation>
            <numerusform>One cause found, </numerusform>
            <numerusform>%n causes found, </numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n still open</source>
        <translation>
            <numerusform>one still open</numerusform>
            <numerusform>%n still open</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n cause(s) found, part unexplained</source>
        <translation>
            <numerusform>One cause found, part unexplained</numerusform>
            <numerusform>%n causes found, part unexplained</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Also tested: %n cause(s)</source>
        <translation>
            <numerusform>Also tested: %n cause</numerusform>
            <numerusform>Also tested: %n causes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ShapeText</name>
    <message numerus="yes">
        <source>%n part(s)</source>
        <translation>
            <numerusform>%n part</numerusform>
            <numerusform>%n parts</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>heft::ExportPanel</name>
    <message numerus="yes">
        <source>%n format(s)</source>
        <translation>
            <numerusform>%n format</numerusform>
            <numerusform>%n formats</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>heft::LiveBoard</name>
    <message numerus="yes">
        <source>%n unmatched sample(s)</source>
        <translation>
            <numerusform>%n unmatched sample</numerusform>
            <numerusform>%n unmatched samples</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n possible contact(s). You can review them in Mark.</source>
        <translation>
            <numerusform>%n possible contact. You can review it in Mark.</numerusform>
            <numerusform>%n possible contacts. You can review them in Mark.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>heft::MarkPanel</name>
    <message numerus="yes">
        <source>%n suggestion(s) to check</source>
        <translation>
            <numerusform>%n suggestion to check</numerusform>
            <numerusform>%n suggestions to check</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>heft::RealityPanel</name>
    <message numerus="yes">
        <source>%n correction(s) applied</source>
        <translation>
            <numerusform>%n correction applied</numerusform>
            <numerusform>%n corrections applied</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n cause(s) to apply</source>
        <translation>
            <numerusform>%n cause to apply</numerusform>
            <numerusform>%n causes to apply</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n correction(s) of an earlier check are part of the result.</source>
        <translation>
            <numerusform>%n correction of an earlier check is part of the result.</numerusform>
            <numerusform>%n corrections of an earlier check are part of the result.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s) already compensated</source>
        <translation>
            <numerusform>%n finding already compensated</numerusform>
            <numerusform>%n findings already compensated</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>heft::RecordPanel</name>
    <message numerus="yes">
        <source>%n pose(s) recorded</source>
        <translation>
            <numerusform>%n pose recorded</numerusform>
            <numerusform>%n poses recorded</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pose(s), recording</source>
        <translation>
            <numerusform>%n pose, recording</numerusform>
            <numerusform>%n poses, recording</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Discard %n pose(s)?</source>
        <translation>
            <numerusform>Discard %n pose?</numerusform>
            <numerusform>Discard %n poses?</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>heft::RoomRow</name>
    <message numerus="yes">
        <source>%1: %n obstacle(s); everything stays at least %2 mm away.</source>
        <translation>
            <numerusform>%1: %n obstacle; everything stays at least %2 mm away.</numerusform>
            <numerusform>%1: %n obstacles; everything stays at least %2 mm away.</numerusform>
        </translation>
    </message>
</context>
</TS>
