<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en">
<context>
    <name>report</name>
    <message numerus="yes">
        <source>NOT in accordance with %1: %n requirement(s) not met.</source>
        <translation>
            <numerusform>NOT in accordance with %1: %n requirement not met.</numerusform>
            <numerusform>NOT in accordance with %1: %n requirements not met.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Test NOT in accordance with %1: %n requirement(s) not met</source>
        <translation>
            <numerusform>Test NOT in accordance with %1: %n requirement not met</numerusform>
            <numerusform>Test NOT in accordance with %1: %n requirements not met</numerusform>
        </translation>
    </message>
</context>
</TS>
