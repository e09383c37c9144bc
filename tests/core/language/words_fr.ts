<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr">
<context>
    <name>report</name>
    <message>
        <source>%1 is %2, the limit %3</source>
        <translation>limite %3, %1 vaut %2</translation>
    </message>
    <message>
        <source>accuracy</source>
        <translation>exactitude</translation>
    </message>
    <message>
        <source>accuracy</source>
        <comment>1988</comment>
        <translation>précision</translation>
    </message>
    <message numerus="yes">
        <source>%n reading(s) at %1</source>
        <translation>
            <numerusform>%n relevé en %1</numerusform>
            <numerusform>%n relevés en %1</numerusform>
        </translation>
    </message>
</context>
</TS>
