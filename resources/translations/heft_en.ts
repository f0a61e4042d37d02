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
    <name>MarkText</name>
    <message numerus="yes">
        <source>Only free parts are used. Please check %n stretch(es).</source>
        <translation>
            <numerusform>Only free parts are used. Please check %n stretch.</numerusform>
            <numerusform>Only free parts are used. Please check %n stretches.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RealityPage</name>
    <message numerus="yes">
        <source>%n cause(s) found, something is left</source>
        <translation>
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
        <translation>
            <numerusform>Also considered: %n cause</numerusform>
            <numerusform>Also considered: %n causes</numerusform>
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
</context>
</TS>
