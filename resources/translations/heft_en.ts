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
        <source>These numbers rest on %n recordings together: %1.</source>
        <translation type="vanished">
            <numerusform>These numbers rest on %n recording: %1.</numerusform>
            <numerusform>These numbers rest on %n recordings together: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Joint result from %n recordings: %1.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
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
        <source>Only free parts are used. Please check %n stretch(es).</source>
        <translation type="vanished">
            <numerusform>Only free parts are used. Please check %n stretch.</numerusform>
            <numerusform>Only free parts are used. Please check %n stretches.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Only free segments are used. Please review %n suggestion(s).</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RealityPage</name>
    <message numerus="yes">
        <source>%n cause(s) found, something is left</source>
        <translation type="vanished">
            <numerusform>One cause found, something is left</numerusform>
            <numerusform>%n causes found, something is left</numerusform>
        </translation>
    </message>
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
        <source>Also considered: %n cause(s)</source>
        <translation type="vanished">
            <numerusform>Also considered: %n cause</numerusform>
            <numerusform>Also considered: %n causes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n cause(s) found, part unexplained</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Also tested: %n cause(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
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
        <source>%n part(s) without a partner</source>
        <translation type="vanished">
            <numerusform>%n part without a partner</numerusform>
            <numerusform>%n parts without a partner</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stretch(es) look touched. You can check them in Mark.</source>
        <translation type="vanished">
            <numerusform>%n stretch looks touched. You can check it in Mark.</numerusform>
            <numerusform>%n stretches look touched. You can check them in Mark.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unmatched sample(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n possible contact(s). You can review them in Mark.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
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
        <source>%n finding(s) that Heft allows for</source>
        <translation type="vanished">
            <numerusform>%n finding that Heft allows for</numerusform>
            <numerusform>%n findings that Heft allows for</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s) already compensated</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
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
        <source>Throw %n pose(s) away?</source>
        <translation type="vanished">
            <numerusform>Throw %n pose away?</numerusform>
            <numerusform>Throw %n poses away?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Discard %n pose(s)?</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>heft::RoomRow</name>
    <message numerus="yes">
        <source>%1: %n obstacle(s), and nothing comes nearer than %2 mm.</source>
        <translation type="vanished">
            <numerusform>%1: %n obstacle, and nothing comes nearer than %2 mm.</numerusform>
            <numerusform>%1: %n obstacles, and nothing comes nearer than %2 mm.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n obstacle(s); everything stays at least %2 mm away.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
</TS>
