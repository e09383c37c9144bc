<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en">
<context>
    <name>palmer::ui::FindingsModel</name>
    <message numerus="yes">
        <source>%n point(s) not agreed</source>
        <translation>
            <numerusform>%n point not agreed</numerusform><numerusform>%n points not agreed</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n required statement(s) missing</source>
        <translation>
            <numerusform>%n required statement missing</numerusform><numerusform>%n required statements missing</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s)</source>
        <translation>
            <numerusform>%n finding</numerusform><numerusform>%n findings</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n requirement(s) not met</source>
        <translation>
            <numerusform>%n requirement not met</numerusform><numerusform>%n requirements not met</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n warning</numerusform><numerusform>%n warnings</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n note</numerusform><numerusform>%n notes</numerusform></translation>
    </message>
</context>
<context>
    <name>palmer::ui::Form</name>
    <message numerus="yes">
        <source>%n required statement(s) missing</source>
        <translation>
            <numerusform>%n required statement missing</numerusform><numerusform>%n required statements missing</numerusform></translation>
    </message>
</context>
<context>
    <name>palmer::ui::NavigationModel</name>
    <message numerus="yes">
        <source>%n required statement(s) missing</source>
        <translation>
            <numerusform>%n required statement missing</numerusform><numerusform>%n required statements missing</numerusform></translation>
    </message>
</context>
<context>
    <name>palmer::ui::ReportDialog</name>
    <message numerus="yes">
        <source>%n required statement(s) missing; printed as “–”</source>
        <translation>
            <numerusform>%n required statement missing; printed as “–”</numerusform><numerusform>%n required statements missing; printed as “–”</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n page(s) %1 · preview = PDF = paper</source>
        <translation>
            <numerusform>%n page %1 · preview = PDF = paper</numerusform><numerusform>%n pages %1 · preview = PDF = paper</numerusform></translation>
    </message>
</context>
<context>
    <name>palmer::ui::Workplace</name>
    <message numerus="yes">
        <source>%n target(s)</source>
        <translation>
            <numerusform>%n target</numerusform><numerusform>%n targets</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n run</numerusform><numerusform>%n runs</numerusform></translation>
    </message>
</context>
</TS>
