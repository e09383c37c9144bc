<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en">
<context>
    <name>edits</name>
    <message numerus="yes">
        <source>clear %n reading(s)</source>
        <translation>
            <numerusform>clear %n reading</numerusform>
            <numerusform>clear %n readings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>set %n reading(s) aside</source>
        <translation>
            <numerusform>set %n reading aside</numerusform>
            <numerusform>set %n readings aside</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>take %n reading(s) back</source>
        <translation>
            <numerusform>take %n reading back</numerusform>
            <numerusform>take %n readings back</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>fill %n reading(s)</source>
        <translation>
            <numerusform>fill %n reading</numerusform>
            <numerusform>fill %n readings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>paste of %n reading(s)</source>
        <translation>
            <numerusform>paste of %n reading</numerusform>
            <numerusform>paste of %n readings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>delete %n target(s)</source>
        <translation>
            <numerusform>delete %n target</numerusform>
            <numerusform>delete %n targets</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>delete %n run(s)</source>
        <translation>
            <numerusform>delete %n run</numerusform>
            <numerusform>delete %n runs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>cut %n reading(s)</source>
        <translation>
            <numerusform>cut %n reading</numerusform>
            <numerusform>cut %n readings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>add %n arc(s)</source>
        <translation>
            <numerusform>add %n arc</numerusform>
            <numerusform>add %n arcs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>examples</name>
    <message numerus="yes">
        <source>%1 · %n arc(s), %2 points</source>
        <translation>
            <numerusform>%1 · %n arc, %2 points</numerusform>
            <numerusform>%1 · %n arcs, %2 points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 · %2 targets, %n run(s)</source>
        <translation>
            <numerusform>%1 · %2 targets, %n run</numerusform>
            <numerusform>%1 · %2 targets, %n runs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::AgreedPointsPage</name>
    <message numerus="yes">
        <source>%n of %1 points to be agreed</source>
        <translation>
            <numerusform>%n of %1 points to be agreed</numerusform>
            <numerusform>%n of %1 points to be agreed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n point(s) that do not apply</source>
        <translation>
            <numerusform>%n point that does not apply</numerusform>
            <numerusform>%n points that do not apply</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::ArcDialog</name>
    <message numerus="yes">
        <source>&amp;Add %n point(s)</source>
        <translation>
            <numerusform>&amp;Add %n point</numerusform>
            <numerusform>&amp;Add %n points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n question(s) to answer</source>
        <translation>
            <numerusform>%n question to answer</numerusform>
            <numerusform>%n questions to answer</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::ComparisonSide</name>
    <message numerus="yes">
        <source>%n common target(s)</source>
        <translation>
            <numerusform>%n common target</numerusform>
            <numerusform>%n common targets</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::ConditionsPage</name>
    <message numerus="yes">
        <source>%n missing</source>
        <translation>
            <numerusform>%n missing</numerusform>
            <numerusform>%n missing</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::FilterBar</name>
    <message numerus="yes">
        <source>%1 of %2 test(s)</source>
        <translation>
            <numerusform>%1 of %2 test</numerusform>
            <numerusform>%1 of %2 tests</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::FindingsModel</name>
    <message numerus="yes">
        <source>%n finding(s)</source>
        <translation>
            <numerusform>%n finding</numerusform>
            <numerusform>%n findings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::ImportAssistant</name>
    <message numerus="yes">
        <source>%n line(s)</source>
        <translation>
            <numerusform>%n line</numerusform>
            <numerusform>%n lines</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n target(s)</source>
        <translation>
            <numerusform>%n target</numerusform>
            <numerusform>%n targets</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n run</numerusform>
            <numerusform>%n runs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n arc(s)</source>
        <translation>
            <numerusform>%n arc</numerusform>
            <numerusform>%n arcs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sensor(s)</source>
        <translation>
            <numerusform>%n sensor</numerusform>
            <numerusform>%n sensors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>&amp;Import %n reading(s)</source>
        <translation>
            <numerusform>&amp;Import %n reading</numerusform>
            <numerusform>&amp;Import %n readings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n missing reading(s)</source>
        <translation>
            <numerusform>%n missing reading</numerusform>
            <numerusform>%n missing readings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n question(s) to answer, and remarks</source>
        <translation>
            <numerusform>%n question to answer, and remarks</numerusform>
            <numerusform>%n questions to answer, and remarks</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n question(s) to answer</source>
        <translation>
            <numerusform>%n question to answer</numerusform>
            <numerusform>%n questions to answer</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) follow</source>
        <translation>
            <numerusform>%n file follows</numerusform>
            <numerusform>%n files follow</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::MachineHead</name>
    <message numerus="yes">
        <source>%n month(s)</source>
        <translation>
            <numerusform>%n month</numerusform>
            <numerusform>%n months</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::MainWindow</name>
    <message numerus="yes">
        <source>%n file(s) have changes that are not saved.</source>
        <translation>
            <numerusform>%n file has changes that are not saved.</numerusform>
            <numerusform>%n files have changes that are not saved.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::PasteBar</name>
    <message numerus="yes">
        <source>%n limit(s) pasted</source>
        <translation>
            <numerusform>%n limit pasted</numerusform>
            <numerusform>%n limits pasted</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n target(s) read</source>
        <translation>
            <numerusform>%n target read</numerusform>
            <numerusform>%n targets read</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reading(s) pasted</source>
        <translation>
            <numerusform>%n reading pasted</numerusform>
            <numerusform>%n readings pasted</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) pasted, channels: %1, temperatures: %2</source>
        <translation>
            <numerusform>%n row pasted, channels: %1, temperatures: %2</numerusform>
            <numerusform>%n rows pasted, channels: %1, temperatures: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n target(s)</source>
        <comment>readings pasted</comment>
        <translation>
            <numerusform>%1 and %n target</numerusform>
            <numerusform>%1 and %n targets</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, %n erased by empty cells</source>
        <comment>readings pasted</comment>
        <translation>
            <numerusform>%1, %n erased by an empty cell</numerusform>
            <numerusform>%1, %n erased by empty cells</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, %n erased by cells that are no numbers</source>
        <comment>readings pasted</comment>
        <translation>
            <numerusform>%1, %n erased by a cell that is no number</numerusform>
            <numerusform>%1, %n erased by cells that are no numbers</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::PlanDialog</name>
    <message numerus="yes">
        <source>%n target(s)</source>
        <translation>
            <numerusform>%n target</numerusform>
            <numerusform>%n targets</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::ReadingsModel</name>
    <message numerus="yes">
        <source>%n reading(s) set aside and left so: take back first (%1)</source>
        <translation>
            <numerusform>%n reading set aside and left so: take back first (%1)</numerusform>
            <numerusform>%n readings set aside and left so: take back first (%1)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::ReadingsPage</name>
    <message numerus="yes">
        <source>Leave out %n target(s) without readings</source>
        <translation>
            <numerusform>Leave out %n target without readings</numerusform>
            <numerusform>Leave out %n targets without readings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::RegisterStatus</name>
    <message numerus="yes">
        <source>%n machine(s)</source>
        <translation>
            <numerusform>%n machine</numerusform>
            <numerusform>%n machines</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n test(s)</source>
        <translation>
            <numerusform>%n test</numerusform>
            <numerusform>%n tests</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n folder(s) watched</source>
        <translation>
            <numerusform>%n folder watched</numerusform>
            <numerusform>%n folders watched</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>reading %1 of %2 file(s)</source>
        <translation>
            <numerusform>reading %1 of %2 file</numerusform>
            <numerusform>reading %1 of %2 files</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unreadable file(s)</source>
        <translation>
            <numerusform>%n unreadable file</numerusform>
            <numerusform>%n unreadable files</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) not found</source>
        <translation>
            <numerusform>%n file not found</numerusform>
            <numerusform>%n files not found</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n test(s) shown</source>
        <translation>
            <numerusform>%n test shown</numerusform>
            <numerusform>%n tests shown</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n chosen</source>
        <translation>
            <numerusform>%n chosen</numerusform>
            <numerusform>%n chosen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::RemarkList</name>
    <message numerus="yes">
        <source>… and %n more remark(s)</source>
        <translation>
            <numerusform>… and %n more remark</numerusform>
            <numerusform>… and %n more remarks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::ReportDialog</name>
    <message numerus="yes">
        <source>%n required statement(s) missing; printed as “–”</source>
        <translation>
            <numerusform>%n required statement missing; printed as “–”</numerusform>
            <numerusform>%n required statements missing; printed as “–”</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n page(s) %1 · preview = PDF = paper</source>
        <translation>
            <numerusform>%n page %1 · preview = PDF = paper</numerusform>
            <numerusform>%n pages %1 · preview = PDF = paper</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>All readings (about %n more page(s))</source>
        <translation>
            <numerusform>All readings (about %n more page)</numerusform>
            <numerusform>All readings (about %n more pages)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::SearchBox</name>
    <message numerus="yes">
        <source>%n answer(s)</source>
        <translation>
            <numerusform>%n answer</numerusform>
            <numerusform>%n answers</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>search: %n answer(s)</source>
        <translation>
            <numerusform>search: %n answer</numerusform>
            <numerusform>search: %n answers</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::SheetPage</name>
    <message numerus="yes">
        <source>%n row(s) pasted</source>
        <translation>
            <numerusform>%n row pasted</numerusform>
            <numerusform>%n rows pasted</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::SimulationRow</name>
    <message numerus="yes">
        <source>%1 trial(s)</source>
        <translation>
            <numerusform>%1 trial</numerusform>
            <numerusform>%1 trials</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::TestTableModel</name>
    <message numerus="yes">
        <source>%n not met</source>
        <translation>
            <numerusform>%n not met</numerusform>
            <numerusform>%n not met</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not declared</source>
        <translation>
            <numerusform>%n not declared</numerusform>
            <numerusform>%n not declared</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::UncertaintyPage</name>
    <message numerus="yes">
        <source>%n input(s) of the budget missing</source>
        <translation>
            <numerusform>%n input of the budget missing</numerusform>
            <numerusform>%n inputs of the budget missing</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::Workplace</name>
    <message numerus="yes">
        <source>%n target(s)</source>
        <translation>
            <numerusform>%n target</numerusform>
            <numerusform>%n targets</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n arc(s)</source>
        <translation>
            <numerusform>%n arc</numerusform>
            <numerusform>%n arcs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reading(s)</source>
        <translation>
            <numerusform>%n reading</numerusform>
            <numerusform>%n readings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n run(s) each way</source>
        <translation>
            <numerusform>%n run each way</numerusform>
            <numerusform>%n runs each way</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n run(s) ↑</source>
        <translation>
            <numerusform>%n run ↑</numerusform>
            <numerusform>%n runs ↑</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n run(s) ↓</source>
        <translation>
            <numerusform>%n run ↓</numerusform>
            <numerusform>%n runs ↓</numerusform>
        </translation>
    </message>
</context>
</TS>
