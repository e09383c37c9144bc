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
        <source>%n not declared</source>
        <comment>departures from practice</comment>
        <translation>
            <numerusform>%n not declared</numerusform>
            <numerusform>%n not declared</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n departure(s) from practice</source>
        <translation>
            <numerusform>%n departure from practice</numerusform>
            <numerusform>%n departures from practice</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n required statement(s) missing</source>
        <translation>
            <numerusform>%n required statement missing</numerusform>
            <numerusform>%n required statements missing</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other required statement(s) missing</source>
        <translation>
            <numerusform>%n other required statement missing</numerusform>
            <numerusform>%n other required statements missing</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recommendation(s)</source>
        <translation>
            <numerusform>%n recommendation</numerusform>
            <numerusform>%n recommendations</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n note</numerusform>
            <numerusform>%n notes</numerusform>
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
    <message numerus="yes">
        <source>%n line(s) without a number: without angles every point is needed</source>
        <translation>
            <numerusform>%n line without a number: without angles every point is needed</numerusform>
            <numerusform>%n lines without a number: without angles every point is needed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>two targets are the same with %n decimal(s): %1</source>
        <translation>
            <numerusform>two targets are the same with %n decimal: %1</numerusform>
            <numerusform>two targets are the same with %n decimals: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Distribution of %1 in %n trial(s)</source>
        <translation>
            <numerusform>Distribution of %1 in %n trial</numerusform>
            <numerusform>Distribution of %1 in %n trials</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 names %n column(s), the table has %2</source>
        <translation>
            <numerusform>%1 names %n column, the table has %2</numerusform>
            <numerusform>%1 names %n columns, the table has %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Rows or columns of the sheet are hidden; what stands there is left out (%n number(s)).</source>
        <translation>
            <numerusform>Rows or columns of the sheet are hidden; what stands there is left out (%n number).</numerusform>
            <numerusform>Rows or columns of the sheet are hidden; what stands there is left out (%n numbers).</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Rows or columns of the sheet are hidden; what stands there is read like the rest (%n number(s)).</source>
        <translation>
            <numerusform>Rows or columns of the sheet are hidden; what stands there is read like the rest (%n number).</numerusform>
            <numerusform>Rows or columns of the sheet are hidden; what stands there is read like the rest (%n numbers).</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The value(s) of %n formula(s) are not in the file and were not read; open the workbook in a spreadsheet program and save it.</source>
        <translation>
            <numerusform>The value of %n formula is not in the file and was not read; open the workbook in a spreadsheet program and save it.</numerusform>
            <numerusform>The values of %n formulas are not in the file and were not read; open the workbook in a spreadsheet program and save it.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The Monte Carlo simulation has %n trial(s): fewer than %1 (JCGM 101, 7.2) never decide. The budget U is used for the verdict.</source>
        <translation>
            <numerusform>The Monte Carlo simulation has %n trial: fewer than %1 (JCGM 101, 7.2) never decide. The budget U is used for the verdict.</numerusform>
            <numerusform>The Monte Carlo simulation has %n trials: fewer than %1 (JCGM 101, 7.2) never decide. The budget U is used for the verdict.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The Monte Carlo simulation has %n trial(s): fewer than %1 (JCGM 101, 7.2) are shown and never decide.</source>
        <translation>
            <numerusform>The Monte Carlo simulation has %n trial: fewer than %1 (JCGM 101, 7.2) are shown and never decide.</numerusform>
            <numerusform>The Monte Carlo simulation has %n trials: fewer than %1 (JCGM 101, 7.2) are shown and never decide.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n target(s) over %1: a long axis has a target in each element of its measuring system or every 250 mm.</source>
        <translation>
            <numerusform>%n target over %1: a long axis has a target in each element of its measuring system or every 250 mm.</numerusform>
            <numerusform>%n targets over %1: a long axis has a target in each element of its measuring system or every 250 mm.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n target(s) over %1: at least 5 per metre are required, %2 here.</source>
        <translation>
            <numerusform>%n target over %1: at least 5 per metre are required, %2 here.</numerusform>
            <numerusform>%n targets over %1: at least 5 per metre are required, %2 here.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n target(s) without any reading: %1.</source>
        <translation>
            <numerusform>%n target without any reading: %1.</numerusform>
            <numerusform>%n targets without any reading: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n target(s) over %1: practice asks for at least %2.</source>
        <translation>
            <numerusform>%n target over %1: practice asks for at least %2.</numerusform>
            <numerusform>%n targets over %1: practice asks for at least %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n target(s) over %1: practice asks for at least 8 per turn, up to 1 800°.</source>
        <translation>
            <numerusform>%n target over %1: practice asks for at least 8 per turn, up to 1 800°.</numerusform>
            <numerusform>%n targets over %1: practice asks for at least 8 per turn, up to 1 800°.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n target(s), %1 faces.</source>
        <translation>
            <numerusform>%n target, %1 faces.</numerusform>
            <numerusform>%n targets, %1 faces.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n month(s)</source>
        <translation>
            <numerusform>%n month</numerusform>
            <numerusform>%n months</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n test(s) without a date are left out.</source>
        <translation>
            <numerusform>%n test without a date is left out.</numerusform>
            <numerusform>%n tests without a date are left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>compared with a table of %1: %n point(s) from %2 to %3</source>
        <translation>
            <numerusform>compared with a table of %1: %n point from %2 to %3</numerusform>
            <numerusform>compared with a table of %1: %n points from %2 to %3</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>compared with a table of %1, axis %4: %n point(s) from %2 to %3</source>
        <translation>
            <numerusform>compared with a table of %1, axis %4: %n point from %2 to %3</numerusform>
            <numerusform>compared with a table of %1, axis %4: %n points from %2 to %3</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Mean over %n target(s): none rules it alone.</source>
        <translation>
            <numerusform>Mean over %n target: none rules it alone.</numerusform>
            <numerusform>Mean over %n targets: none rules it alone.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n row(s), for a report prints no more than %1 of them unasked. The test file holds all readings. To print the rows as well, choose “All readings” for the report, or write “allReadings” under “include” in the test file.</source>
        <translation>
            <numerusform>Left out: %n row, for a report prints no more than %1 of them unasked. The test file holds all readings. To print the row as well, choose “All readings” for the report, or write “allReadings” under “include” in the test file.</numerusform>
            <numerusform>Left out: %n rows, for a report prints no more than %1 of them unasked. The test file holds all readings. To print the rows as well, choose “All readings” for the report, or write “allReadings” under “include” in the test file.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Monte Carlo: %n trial(s) of the whole evaluation, seed %1; U is half of the shortest interval that holds 95.45 % of the results, the shift their mean less the evaluated value.</source>
        <translation>
            <numerusform>Monte Carlo: %n trial of the whole evaluation, seed %1; U is half of the shortest interval that holds 95.45 % of the results, the shift their mean less the evaluated value.</numerusform>
            <numerusform>Monte Carlo: %n trials of the whole evaluation, seed %1; U is half of the shortest interval that holds 95.45 % of the results, the shift their mean less the evaluated value.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Monte Carlo: %n trial(s), seed %1, otherwise as for test %2.</source>
        <translation>
            <numerusform>Monte Carlo: %n trial, seed %1, otherwise as for test %2.</numerusform>
            <numerusform>Monte Carlo: %n trials, seed %1, otherwise as for test %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Not simulated: %n reading(s); the method Monte Carlo (--uncertainty monteCarlo) does it.</source>
        <translation>
            <numerusform>Not simulated: %n reading; the method Monte Carlo (--uncertainty monteCarlo) does it.</numerusform>
            <numerusform>Not simulated: %n readings; the method Monte Carlo (--uncertainty monteCarlo) does it.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n question(s) are open: nothing was imported; answer with --set, or take what is assumed with --accept</source>
        <translation>
            <numerusform>%n question is open: nothing was imported; answer with --set, or take what is assumed with --accept</numerusform>
            <numerusform>%n questions are open: nothing was imported; answer with --set, or take what is assumed with --accept</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n question(s) are open: nothing was imported; each wants its own answer with --set</source>
        <translation>
            <numerusform>%n question is open: nothing was imported; it wants its own answer with --set</numerusform>
            <numerusform>%n questions are open: nothing was imported; each wants its own answer with --set</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n check(s)</source>
        <translation>
            <numerusform>%n check</numerusform>
            <numerusform>%n checks</numerusform>
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
        <source>all %n row(s) met</source>
        <translation>
            <numerusform>the only row met</numerusform>
            <numerusform>all %n rows met</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 rows met</source>
        <translation>
            <numerusform>%n of %1 rows met</numerusform>
            <numerusform>%n of %1 rows met</numerusform>
        </translation>
    </message>
</context>
</TS>
