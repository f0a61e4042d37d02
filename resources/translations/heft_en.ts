<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
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
