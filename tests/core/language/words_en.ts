<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en">
<context>
    <name>report</name>
    <message numerus="yes">
        <source>%n reading(s) at %1</source>
        <translation>
            <numerusform>%n reading at %1</numerusform>
            <numerusform>%n readings at %1</numerusform>
        </translation>
    </message>
</context>
</TS>
