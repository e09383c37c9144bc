<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en">
<context>
    <name>report</name>
    <message numerus="yes">
        <source>Test NOT in accordance with %1: %n requirement(s) not met</source>
        <translation>
            <numerusform>Test NOT in accordance with %1: %n requirement not met</numerusform>
            <numerusform>Test NOT in accordance with %1: %n requirements not met</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 limits</source>
        <translation>
            <numerusform>%n of %1 limits</numerusform>
            <numerusform>%n of %1 limits</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Met: %n of %1 limits.</source>
        <translation>
            <numerusform>Met: %n of %1 limits.</numerusform>
            <numerusform>Met: %n of %1 limits.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No reading at %1 (%n in all): the statistics use the readings that exist.</source>
        <translation>
            <numerusform>No reading at %1 (%n in all): the statistics use the readings that exist.</numerusform>
            <numerusform>No reading at %1 (%n in all): the statistics use the readings that exist.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Readings that are no numbers (%n), hence missing: %1.</source>
        <translation>
            <numerusform>Readings that are no numbers (%n), hence missing: %1.</numerusform>
            <numerusform>Readings that are no numbers (%n), hence missing: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Readings set aside without a reason: %n.</source>
        <translation>
            <numerusform>Readings set aside without a reason: %n.</numerusform>
            <numerusform>Readings set aside without a reason: %n.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Readings set aside (%n): %1. The text provides for none.</source>
        <translation>
            <numerusform>Readings set aside (%n): %1. The text provides for none.</numerusform>
            <numerusform>Readings set aside (%n): %1. The text provides for none.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Readings set aside (%n): %1.</source>
        <translation>
            <numerusform>Readings set aside (%n): %1.</numerusform>
            <numerusform>Readings set aside (%n): %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Accordance with %1 not shown: %n requirement(s) not declared</source>
        <translation>
            <numerusform>Accordance with %1 not shown: %n requirement not declared</numerusform>
            <numerusform>Accordance with %1 not shown: %n requirements not declared</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not declared</source>
        <translation>
            <numerusform>%n not declared</numerusform>
            <numerusform>%n not declared</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>; %n departure(s) from practice</source>
        <translation>
            <numerusform>; %n departure from practice</numerusform>
            <numerusform>; %n departures from practice</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n difference(s): the report does not follow from the attached data.</source>
        <translation>
            <numerusform>%n difference: the report does not follow from the attached data.</numerusform>
            <numerusform>%n differences: the report does not follow from the attached data.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) that this version prints otherwise: not compared</source>
        <translation>
            <numerusform>%n place that this version prints otherwise: not compared</numerusform>
            <numerusform>%n places that this version prints otherwise: not compared</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Summary of %n test(s)</source>
        <translation>
            <numerusform>Summary of %n test</numerusform>
            <numerusform>Summary of %n tests</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n requirement(s) not met</source>
        <translation>
            <numerusform>%n requirement not met</numerusform>
            <numerusform>%n requirements not met</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n requirement(s) not declared</source>
        <translation>
            <numerusform>%n requirement not declared</numerusform>
            <numerusform>%n requirements not declared</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>all readings are to be printed, on about %n more page(s): that takes time and memory; without “allReadings” under “include” the report says how many it leaves out</source>
        <translation>
            <numerusform>all readings are to be printed, on about %n more page: that takes time and memory; without “allReadings” under “include” the report says how many it leaves out</numerusform>
            <numerusform>all readings are to be printed, on about %n more pages: that takes time and memory; without “allReadings” under “include” the report says how many it leaves out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not met</source>
        <translation>
            <numerusform>%n not met</numerusform>
            <numerusform>%n not met</numerusform>
        </translation>
    </message>
</context>
</TS>
