// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/import/importpicture.h"

#include <QTest>
#include <algorithm>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

using namespace palmer;

namespace {

/// Roles without ignored ends, the runs, the questions that are not asked of every table: "roles / ↑ … /
/// ids".
QString outcome(const QByteArray &text, const ImportOptions &options = {}) {
    Imported imported;
    try {
        imported = importMeasurement(text, "x.csv", options);
    } catch (const Error &) {
        return "refused";
    }
    QStringList lines{QString::fromStdString(wordOf(imported.columns))};
    const QStringList picture = testdata::picture(imported).split('\n');
    for (const QString &line : picture) {
        if (line.startsWith("ISO 230-2"))
            lines << line.section(':', 2).trimmed();
        else
            lines << line;
    }
    QStringList ids;
    for (const Question &question : imported.questions) {
        if (question.id != "sign" && question.id != "correctionTo20")
            ids << QString::fromStdString(question.id);
    }
    ids.sort();
    lines << ids.join(' ');
    return lines.join(" / ");
}

} // namespace

/// Tables as they lie about in workshops, with what a reader of them would say: roles of the columns, targets
/// in mm, readings in µm, and the questions. Written by hand, from the tables alone.
class LayoutsTest : public QObject {
    Q_OBJECT

private slots:
    void areReadAsPeopleReadThem_data();
    void areReadAsPeopleReadThem();
    void everyProposalCanBeKept_data();
    void everyProposalCanBeKept();
    void answersAreTaken_data();
    void answersAreTaken();
    void namesAllColumnsLeftOut();
    void aSignProvenByPositionsIsSaid();
    void aDirectionAboveTheTargetsIsDoubted();
    void anotherOrderOfDirectionsIsSaid();
    void anOrderOfRunsIsNoOrderOfDirections();
    void anOrderThatIsNotStatedIsInTurn_data();
    void anOrderThatIsNotStatedIsInTurn();
    void directionsOfFarPositionsAreGuessedAsOfNearOnes();
};

void LayoutsTest::areReadAsPeopleReadThem_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *name, const char *text, const char *expected) {
        QTest::newRow(name) << QByteArray(text) << QString(expected);
    };
    // The form of ISO 230-2: each target above the columns of its two directions.
    row("the form of the standard",
        "Position no. i;1;;2;;3;\nTarget (mm);0;;100;;200;\nApproach;↑;↓;↑;↓;↑;↓\n"
        "Deviation 1 (µm);1;2;3;4;5;6\nDeviation 2 (µm);1.5;2.5;3.5;4.5;5.5;6.5\n"
        "Mean (µm);1.2;2.2;3.2;4.2;5.2;6.2\nB (µm);-1;;-1;;-1;\n",
        "ignored,run+,run-,run+,run-,run+,run- / 0 100 200 / ↑ 1 3 5 / ↓ 2 4 6 / ↑ 1.5 3.5 5.5 / ↓ 2.5 4.5 "
        "6.5 / ");
    row("the form, targets in each column",
        "Cible (mm);0;0;100;100;200;200\nSens;aller;retour;aller;retour;aller;retour\n"
        "Écart 1 [µm];1;2;3;4;5;6\n",
        "ignored,run+,run-,run+,run-,run+,run- / 0 100 200 / ↑ 1 3 5 / ↓ 2 4 6 / ");
    // Columns of fixed width: a single blank parts the words of a label.
    row("targets in the words of headings",
        "Direction;Run;Target 0 mm;Target 100 mm;Target 200 mm\nforward;1;1;2;3\nreverse;1;4;5;6\n"
        "forward;2;1.5;2.5;3.5\nreverse;2;4.5;5.5;6.5\n",
        "direction,ignored,run,run,run / 0 100 200 / ↑ 1 2 3 / ↓ 4 5 6 / ↑ 1.5 2.5 3.5 / ↓ 4.5 5.5 6.5 / "
        "content unit");
    row("targets across behind a margin",
        ";Run;Target (mm);0;100;200\n;1;forward (µm);1;2;3\n;1;reverse (µm);4;5;6\n",
        "ignored,ignored,direction,run,run,run / 0 100 200 / ↑ 1 2 3 / ↓ 4 5 6 / ");
    row("targets that are only numbered", "Run;Direction;P1;P2;P3\n1;forward;1;2;3\n1;reverse;4;5;6\n",
        "number,direction,target,run2,run3 / 1 4 / ↑ 2 – / ↓ – 5 / ↑ 3 – / ↓ – 6 / columns content "
        "positionUnit unit");
    row("a line without its first cell",
        "Target (mm);↑ 1 (µm);↓ 1 (µm)\n0;1;2\n100;3;4\n200;5;6\n7;8\n400;9;10\n500;11;12\n",
        "target,run+1,run-1 / 0 7 100 200 400 500 / ↑ 1 8 3 5 9 11 / ↓ 2 – 4 6 10 12 / columns");
    // Units above or below what they belong to.
    row("units of some columns",
        "No.;Target;Direction;Run;Deviation\n;[mm];;;[nm]\n1;0;up;1;100\n2;100;up;1;200\n"
        "3;100;down;1;300\n4;0;down;1;400\n",
        "ignored,target,direction,number,deviation / 0 100 / ↑ 0.1 0.2 / ↓ 0.4 0.3 / ");
    row("units of columns that blanks do not tell",
        "Target   Direction   Run   Deviation\n[mm]                       [nm]\n0   up   1   100\n100   up   "
        "1   200\n"
        "100   down   1   300\n0   down   1   400\n",
        "target,direction,number,deviation / 0 100 / ↑ 100 200 / ↓ 400 300 / positionUnit unit unit");
    row("blocks of falling targets",
        "Avance\nTarget (mm);Error (µm)\n100;1\n0;2\n\nRetorno\nTarget (mm);Error (µm)\n100;3\n0;4\n",
        "target,deviation / 0 100 / ↑ 2 1 / ↓ 4 3 / directions");
    row("inches in bars",
        "| Pos. | up 1 | down 1 |\n|---|---|---|\n| in | in | in |\n| 0 | 0.001 | 0.002 |\n"
        "| 1 | 0.003 | 0.004 |\n",
        "ignored,target,run+1,run-1,ignored / 0 25.4 / ↑ 25.4 76.2 / ↓ 50.8 101.6 / ");
    row("integers in bars",
        "| Cote (mm) | 0 | 50 | 100 |\n|---|---|---|---|\n| Écart positif 1 (nm) | -400 | 500 | 1200 |\n"
        "| Écart négatif 1 (nm) | -1800 | -1000 | 300 |\n",
        "ignored,ignored,run,run,run,ignored / 0 50 100 / ↑ -0.4 0.5 1.2 / ↓ -1.8 -1 0.3 / ");
    row("units above targets across",
        ";;Deviation (nm) at position (in)\nRun;Direction;0;10;20\n1;forward;40;120;250\n"
        "1;reverse;140;220;350\n",
        "ignored,direction,run,run,run / 0 254 508 / ↑ 0.04 0.12 0.25 / ↓ 0.14 0.22 0.35 / ");
    row("a table of LaTeX",
        "\\begin{tabular}{rrr}\nPosition (mm) & up (µm) & down (µm) \\\\\n0 & 1 & 2 \\\\\n100 & 3 & 4 \\\\\n"
        "\\end{tabular}\n",
        "target,run+,run- / 0 100 / ↑ 1 3 / ↓ 2 4 / ");
    row("a table of LaTeX with spanning headings",
        "Axis: X\n\\begin{tabular}{lrrrr}\n\\toprule\n & \\multicolumn{2}{c}{Run 1} & "
        "\\multicolumn{2}{c}{Run 2} \\\\\nTarget (mm) & $\\uparrow$ (nm) & $\\downarrow$ (nm) & $\\uparrow$ "
        "(nm) & "
        "$\\downarrow$ (nm) \\\\ \\midrule\n0 & 10 & $-20$ & 30 & 40 \\\\\n100 & 50 & 60 & 70 & 80 \\\\\n"
        "\\bottomrule\n\\end{tabular}\n",
        "target,run+1,run-1,run+2,run-2 / 0 100 / ↑ 0.01 0.05 / ↓ -0.02 0.06 / ↑ 0.03 0.07 / ↓ 0.04 0.08 / ");
    // Other languages.
    row("Dutch", "Positie (mm);Heen 1 (µm);Terug 1 (µm)\n0;1;2\n100;3;4\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 3 / ↓ 2 4 / ");
    row("Portuguese",
        "Posição (mm);Desvio avanço 1 (µm);Desvio retorno 1 (µm);Desvio padrão (µm)\n0;1;2;7\n100;3;4;8\n",
        "target,deviation+1,deviation-1,statistic / 0 100 / ↑ 1 3 / ↓ 2 4 / ");
    row("Polish", "Lp.;Pozycja (mm);Cykl 1 naprzód (µm);Cykl 1 wstecz (µm)\n1;0;1;2\n2;100;3;4\n",
        "ignored,target,run+1,run-1 / 0 100 / ↑ 1 3 / ↓ 2 4 / ");
    row("Russian", "Позиция (мм);Отклонение туда (мкм);Отклонение обратно (мкм);СКО\n0;1;2;7\n100;3;4;8\n",
        "target,deviation+,deviation-,statistic / 0 100 / ↑ 1 3 / ↓ 2 4 / ");
    row("Chinese", "序号;位置 (mm);次数 1 正行程 (µm);次数 1 反行程 (µm);标准偏差\n1;0;1;2;7\n2;100;3;4;8\n",
        "ignored,target,run+1,run-1,statistic / 0 100 / ↑ 1 3 / ↓ 2 4 / ");
    row("labels of fixed width",
        "  Axis position (mm)   10.000   160.000   304.280\n           up 1 (µm)      3.3       0.1     "
        " -2.2\n         down 1 (µm)      6.2       3.9       2.3\n",
        "ignored,run,run,run / 10 160 304.28 / ↑ 3.3 0.1 -2.2 / ↓ 6.2 3.9 2.3 / ");
    row("labels of fixed width with signs",
        "Quota (mm)         -200,0    100,0    300,0\ndirezione + 1 µm     -7,1     -0,8      2,0\n"
        "direzione - 1 µm     -5,7     -2,7      2,3\n",
        "ignored,run,run,run / -200 100 300 / ↑ -7.1 -0.8 2 / ↓ -5.7 -2.7 2.3 / directions");
    row("directions of two words, of fixed width",
        "Dir.        Target (mm)  Positional deviation (µm)   Run no.\n"
        "approach +  0.000        3.2                         1\n"
        "approach +  25.000       2.3                         1\n"
        "approach -  25.000       1.3                         1\n"
        "approach -  0.000        0.1                         1\n",
        "direction,target,deviation,number / 0 25 / ↑ 3.2 2.3 / ↓ 0.1 1.3 / ");
    row("groups flush right",
        "                   Error [µm]\n                       avanti              indietro\n"
        "    Quota [mm]        Prova 1    Prova 2    Prova 1    Prova 2\n"
        "         10,00            1,9        3,7        6,3        5,9\n"
        "         58,67            2,0        2,5        4,5        4,2\n"
        "        114,17            0,0       -0,4        2,6        2,0\n",
        "target,deviation+1,deviation+2,deviation-1,deviation-2 / 10 58.67 114.17 / ↑ 1.9 2 0 / ↓ 6.3 4.5 "
        "2.6 "
        "/ ↑ 3.7 2.5 -0.4 / ↓ 5.9 4.2 2 / ");
    // The bars of Markdown: what stands above its table is no group of headings.
    row("statements in bars above a table in bars",
        "# Report\n\n|  |  |\n|---|---|\n| N° série instrument | 81A55 |\n| Contrôleur | K. O |\n"
        "| Commande | R/77 |\n\n| Cote (mm) | Écart + 1 (µm) | Écart - 1 (µm) |\n|---|---:|---:|\n"
        "| 0 | 1 | 2 |\n| 100 | 3 | 4 |\n",
        "ignored,target,deviation+1,deviation-1,ignored / 0 100 / ↑ 1 3 / ↓ 2 4 / ");
    // Positions that prove the deviations beside them.
    row("readings beside errors",
        "Target (mm);Reading up 1 (mm);Error up 1 (mm);Reading down 1 (mm);Error down 1 (mm)\n"
        "0;0.0012;0.0012;0.0022;0.0022\n100;100.0021;0.0021;100.0031;0.0031\n"
        "200;199.999;-0.001;200.001;0.001\n",
        "target,actual,deviation+1,actual,deviation-1 / 0 100 200 / ↑ 1.2 2.1 -1 / ↓ 2.2 3.1 1 / ");
    // Words and errors of a spreadsheet in place of a reading.
    row("a word in two columns",
        "↑\nTarget (mm);Error (µm)\n0;1\n100;beam lost\n200;3\n300;4\n\n↓\nTarget (mm);Error (µm)\n"
        "0;5\n100;6\n200;7\n300;8\n",
        "target,deviation / 0 100 200 300 / ↑ 1 – 3 4 / ↓ 5 6 7 8 / unread");
    row("an error of a spreadsheet",
        "↑\nTarget (mm);Error (µm)\n0;1\n100;#DIV/0!\n200;3\n300;4\n\n↓\nTarget (mm);Error (µm)\n"
        "0;5\n100;****\n200;7\n300;--.-\n",
        "target,deviation / 0 100 200 300 / ↑ 1 – 3 4 / ↓ 5 – 7 – / unread");
    // The end of a file that was cut.
    row("cut within a number", "Target (mm);↑ (µm);↓ (µm)\n0;1.5;2.5\n100;3.5;4.5\n200;5.5;-1",
        "target,run+,run- / 0 100 200 / ↑ 1.5 3.5 5.5 / ↓ 2.5 4.5 -1 / unread");
    row("LaTeX cut within a number",
        "\\begin{tabular}{rrr}\nTarget (mm) & ↑ (µm) & ↓ (µm) \\\\\n0 & 1.5 & 2.5 \\\\\n100 & 3.5 & 4.5 "
        "\\\\\n200 & 5.5 & -1",
        "target,run+,run- / 0 100 200 / ↑ 1.5 3.5 5.5 / ↓ 2.5 4.5 -1 / unread");
    row("a command of LaTeX that is not known",
        "\\begin{tabular}{rrr}\nTarget (mm) & ↑ (µm) & ↓ (µm) \\\\\n0 & 1 & $\\textminus 2$ \\\\\n100 & 3 & "
        "$\\pm "
        "4$ \\\\\n200 & 5 & \\num{6} \\\\\n\\end{tabular}\n",
        "target,run+,run- / 0 100 200 / ↑ 1 3 5 / ↓ -2 – 6 / unread");
    row("cut within a line", "Target (mm);↑ (µm);↓ (µm)\n0;1.5;2.5\n100;3.5;4.5\n200;5.5",
        "target,run+,run- / 0 100 200 / ↑ 1.5 3.5 5.5 / ↓ 2.5 4.5 – / unread");
    row("no end of the last line", "Target (mm);↑ (µm);↓ (µm)\n0;1.5;2.5\n100;3.5;4.5\n200;5.5;-1.5",
        "target,run+,run- / 0 100 200 / ↑ 1.5 3.5 5.5 / ↓ 2.5 4.5 -1.5 / ");
    row("a list of decimal commas between words",
        "Target (mm)\tDirection\tRun\tError (µm)\n0,000\tforward\t1\t3,0\n100,000\tforward\t1\t3,6\n"
        "100,000\treverse\t1\t4,0\n0,000\treverse\t1\t-0,7\n",
        "target,direction,number,deviation / 0 100 / ↑ 3 3.6 / ↓ -0.7 4 / ");
    row("a title and statements above targets across",
        "Mesure laser\nMachine;X\nCN;840D\nÉtalonné le;24.07.2022\nRemarque;fermé\n\n"
        "Cible (mm);0;100;200\nAller 1 (µm);1;2;3\nRetour 1 (µm);4;5;6\n",
        "ignored,run,run,run / 0 100 200 / ↑ 1 2 3 / ↓ 4 5 6 / ");
    // Columns of different meaning.
    row("target, measured, deviation",
        "Target;Measured (mm);Deviation (µm)\n0;0.0012;1.2\n100;100.0021;2.1\n200;199.999;-1\n",
        "target,actual,deviation / 0 100 200 / ↑ 1.2 2.1 -1 / directions positionUnit");
    row("the same, all units",
        "Target (mm);Measured (mm);Deviation (µm)\n0;0.0012;1.2\n100;100.0021;2.1\n200;199.999;-1\n",
        "target,actual,deviation / 0 100 200 / ↑ 1.2 2.1 -1 / directions");
    row("measured and deviation disagree",
        "Target (mm);Measured (mm);Deviation (µm)\n0;0.0012;5\n100;100.0021;7\n200;199.999;9\n",
        "target,actual,deviation / 0 100 200 / ↑ 5 7 9 / columns directions");
    row("Soll, Ist, Abweichung", "Soll [mm];Ist [mm];Abw. [µm]\n0;0,001;1\n100;100,002;2\n200;199,999;-1\n",
        "target,actual,deviation / 0 100 200 / ↑ 1 2 -1 / directions");
    row("two kinds of readings", "Target (mm);Run 1 (µm);Deviation (µm)\n0;1;4\n100;2;5\n",
        "target,ignored,deviation / 0 100 / ↑ 4 5 / columns columns directions");
    row("two units", "Target (mm);Dev 1 (µm);Dev 2 (mm);Dev 3 (µm)\n0;1;0.004;7\n100;2;0.005;8\n",
        "target,deviation1,ignored,deviation3 / 0 100 / ↑ 1 2 / ↓ 7 8 / columns columns directions");
    row("temperature behind the targets",
        "Soll-Pos. mm;0.00;30.31;59.49;Temperatur (°C)\n1 Hinfahrt µm;0.3;1.8;0.9;20.0\n"
        "1 Rückfahrt µm;-0.6;-1.7;0.1;20.2\n",
        "ignored,run,run,run,ignored / 0 30.31 59.49 / ↑ 0.3 1.8 0.9 / ↓ -0.6 -1.7 0.1 / ");
    row("temperature beside", "Target (mm);↑1 (µm);↓1 (µm);Temp (°C)\n0;1;2;20.1\n100;3;4;20.2\n",
        "target,run+1,run-1,temperature / 0 100 / ↑ 1 3 / ↓ 2 4 / ");
    row("time beside", "Target (mm);Time (s);↑1 (µm);↓1 (µm)\n0;0;1;2\n100;10;3;4\n",
        "target,time,run+1,run-1 / 0 100 / ↑ 1 3 / ↓ 2 4 / ");
    // Words for what was measured, beside which a sign says the direction.
    for (const char *word :
         {"Positional deviation", "Positioning error", "Écart de positionnement", "Erreur de positionnement",
          "Écart linéaire", "Défaut de position", "Positionierabweichung", "Positionierfehler", "Wegfehler",
          "Wegabweichung", "Istabweichung", "Lineare Abweichung", "Errore di posizionamento",
          "Scarto di posizionamento", "Scost.", "Error de posicionamiento", "Desviación de posicionamiento",
          "Error lineal"}) {
        const QByteArray name(word);
        QTest::newRow(name + " + and -")
            << "Pos. (mm);" + name + " + 1 (µm);" + name + " - 1 (µm)\n0;1;2\n100;3;4\n200;5;7\n"
            << "target,deviation+1,deviation-1 / 0 100 200 / ↑ 1 3 5 / ↓ 2 4 7 / ";
        QTest::newRow(name + " +ve and -ve")
            << "Pos. (mm);" + name + " +ve 1 (µm);" + name + " -ve 1 (µm)\n0;1;2\n100;3;4\n200;5;7\n"
            << "target,deviation+1,deviation-1 / 0 100 200 / ↑ 1 3 5 / ↓ 2 4 7 / ";
    }
    // Labels with their values above targets that stand across.
    for (const char *above :
         {"Date;2024-03-05\n", "Machine;DMU 50\nDate;2024-03-05\n", "Machine;DMU 50\nSerial no;4711\n\n",
          "Temperature;20.3;°C\n", "Temperature;20.3;°C;;\n\n", "Datum;05.03.2024\nMaschine;HERMLE\n",
          "Order no.:;4711\nAxis;X\n"}) {
        const QByteArray name(above);
        QTest::newRow("above targets across: " + name.simplified())
            << name + "Position (mm);0;100;200\n↑ 1 (µm);1.1;3;5\n↓ 1 (µm);2.1;4;6\n"
            << "ignored,run,run,run / 0 100 200 / ↑ 1.1 3 5 / ↓ 2.1 4 6 / " +
                   QString(name.startsWith("Temp") ? "sensor Temperature – 20.3 / " : "");
    }
    // Headings that no line reaches: they may stand a column too far to the right.
    row("a heading more than cells", "Nr;Target (mm);Up 1 (µm);Up 2 (µm)\n0;1;2\n100;2;3\n200;3;4\n",
        "ignored,target,run+1 / 1 2 3 / ↑ 2 3 4 / columns");
    row("a heading of no reading more than cells",
        "Target (mm);Up 1 (µm);Down 1 (µm);Remark\n0;1;2\n100;2;3\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 2 / ↓ 2 3 / ");
    row("a run that is still to be made",
        "Target (mm);Up 1 (µm);Down 1 (µm);Up 2 (µm)\n0;1;2;\n100;2;3;\n200;3;4;\n",
        "target,run+1,run-1,ignored / 0 100 200 / ↑ 1 2 3 / ↓ 2 3 4 / ");
    row("a remark more than cells, no targets first",
        "Nr;Target (mm);Up 1 (µm);Remark\n0;1;2\n100;2;3\n200;3;4\n",
        "ignored,target,run+1 / 1 2 3 / ↑ 2 3 4 / columns");
    row("one line alone goes as far as the headings",
        "Target (mm);Up 1 (µm);Down 1 (µm);Up 2 (µm)\n0;1;2;7\n100;2;3\n200;3;4\n",
        "target,run+1,run-1 / 100 200 / ↑ 2 3 / ↓ 3 4 / columns unread");
    // One further column cancels nothing.
    for (const char *name :
         {"B",         "s",     "Min",        "Max",      "R",       "Umkehrspanne", "Écart type", "Remark",
          "Mean",      "Media", "Mittelwert", "Reversal", "Moyenne", "Std dev",      "Inversión",  "Gioco",
          "Tolerance", "Feed",  "Batch",      "Wxyz",     "U",       "Notes",        "Streuung",   "Étendue"})
        QTest::newRow(qPrintable(QString("further column %1").arg(name)))
            << QByteArray("P (mm);1↑ (µm);1↓ (µm);2↑ (µm);2↓ (µm);") + name +
                   "\n0;1;5;2;6;0.5\n100;3;7;4;8;0.7\n"
            << QString("target,run+1,run-1,run+2,run-2,%1 / 0 100 / ↑ 1 3 / ↓ 5 7 / ↑ 2 4 / ↓ 6 8 / ")
                   .arg(QStringList{"Tolerance", "Feed", "Batch", "Wxyz", "Remark", "Notes"}.contains(name)
                            ? "ignored"
                            : "statistic");
    // Words that are no directions.
    row("Pos (mm)",
        "Soll-Pos. (mm);Pos 1 (mm);Pos 2 (mm)\n0;0.001;0.002\n100;100.003;100.004\n200;200.003;200.004\n",
        "target,actual1,actual2 / 0 100 200 / ↑ 1 3 3 / ↓ 2 4 4 / directions");
    row("Meas. pos.",
        "Target pos. (mm);Meas. pos. 1 (mm);Meas. pos. 2 "
        "(mm)\n0;0.001;0.002\n100;100.003;100.004\n200;200.003;200.004\n",
        "target,actual1,actual2 / 0 100 200 / ↑ 1 3 3 / ↓ 2 4 4 / directions");
    row("signs alone as titles",
        "+\nTarget (mm);Run 1 (µm);Run 2 (µm)\n0;1;2\n100;3;4\n\n"
        "-\nTarget (mm);Run 1 (µm);Run 2 (µm)\n0;5;6\n100;7;8\n",
        "target,run1,run2 / 0 100 / ↑ 1 3 / ↓ 5 7 / ↑ 2 4 / ↓ 6 8 / ");
    // A measured what? The values say it, and it is asked.
    row("Medida in µm", "Posición (mm);Medida 1 (µm);Medida 2 (µm)\n0;1.2;2.2\n100;2;3\n200;-1;4\n",
        "target,actual1,actual2 / 0 100 200 / ↑ 1.2 2 -1 / ↓ 2.2 3 4 / content directions");
    row("Medida in µm, positions",
        "Posición (mm);Medida 1 (µm);Medida 2 (µm)\n0;1;2\n100;100002;100003\n200;199999;200004\n",
        "target,actual1,actual2 / 0 100 200 / ↑ 1 2 -1 / ↓ 2 3 4 / directions");
    row("a short axis measured in µm", "Posición (mm);Medida 1 (µm)\n0;1\n1;1002\n2;1999\n",
        "target,actual1 / 0 1 2 / ↑ 1 2 -1 / directions");
    row("rev in a title", "X axis rev 2\nTarget (mm);1 (µm);2 (µm)\n0;1;5\n100;3;7\n",
        "target,run1,run2 / 0 100 / ↑ 1 3 / ↓ 5 7 / directions");
    row("Dec in a title", "12 Dec 2023\nTarget (mm);1 (µm);2 (µm)\n0;1;5\n100;3;7\n",
        "target,run1,run2 / 0 100 / ↑ 1 3 / ↓ 5 7 / directions");
    row("back in a title", "Mill with back spindle\n\nTarget (mm);1 (µm);2 (µm)\n0;1;5\n100;3;7\n",
        "target,run1,run2 / 0 100 / ↑ 1 3 / ↓ 5 7 / directions");
    // Directions in five languages.
    const auto directions = [&](const char *name, const char *up, const char *down) {
        QTest::newRow(name) << QByteArray("Target (mm);") + up + " 1 (µm);" + down +
                                   " 1 (µm)\n0;1;5\n100;3;7\n"
                            << QString("target,run+1,run-1 / 0 100 / ↑ 1 3 / ↓ 5 7 / ");
    };
    directions("forward", "forward", "backward");
    directions("Forward, reverse", "Forward", "Reverse");
    directions("up", "Up", "Down");
    directions("fwd", "Fwd", "Bwd");
    directions("positive", "Positive approach", "Negative approach");
    directions("aller", "Aller", "Retour");
    directions("approche", "Approche positive", "Approche négative");
    directions("sens", "Sens +", "Sens -");
    directions("montée", "Montée", "Descente");
    directions("hin", "hin", "rück");
    directions("Hinfahrt", "Hinfahrt", "Rückfahrt");
    directions("vorwärts", "vorwärts", "rückwärts");
    directions("vorwaerts", "vorwaerts", "rueckwaerts");
    directions("positiv", "positiv", "negativ");
    directions("andata", "Andata", "Ritorno");
    directions("avanti", "avanti", "indietro");
    directions("ida", "Ida", "Vuelta");
    directions("adelante", "adelante", "atrás");
    directions("arrows", "↑", "↓");
    directions("Run", "Run +", "Run −");
    // Abbreviations count beside their opposite, and are asked.
    row("pos and neg", "Target (mm);pos 1 (µm);neg 1 (µm)\n0;1;5\n100;3;7\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 3 / ↓ 5 7 / directions");
    row("A and R", "Point (mm);1A (µm);1R (µm)\n0;1;5\n100;3;7\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 3 / ↓ 5 7 / directions");
    row("fwd and rev", "Target (mm);fwd 1 (µm);rev 1 (µm)\n0;1;5\n100;3;7\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 3 / ↓ 5 7 / ");
    // Two axes are two tests.
    row("X and Y", "Position (mm);X ↑ (µm);X ↓ (µm);Y ↑ (µm);Y ↓ (µm)\n0;1;2;30;40\n100;3;4;50;60\n",
        "target,run+,run-,ignored,ignored / 0 100 / ↑ 1 3 / ↓ 2 4 / axis");
    row("axis in a column", "Axis;Target (mm);Dir;Dev (µm)\nX;0;+;1\nX;100;+;2\nY;0;+;30\nY;100;+;40\n",
        "ignored,target,direction,deviation / 0 100 / ↑ 1 2 / axis");
    row("blocks of two axes",
        "Axis X\nTarget (mm);↑1 (µm);↓1 (µm)\n0;1;2\n100;3;4\n\nAxis Y\nTarget (mm);↑1 (µm);↓1 "
        "(µm)\n0;10;20\n100;30;40\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 3 / ↓ 2 4 / axis");
    // Blocks, stacks, lists.
    row("blocks",
        "Hinfahrt\nSoll (mm);1 (µm);2 (µm)\n0;1;2\n100;3;4\n\nRückfahrt\nSoll (mm);1 (µm);2 "
        "(µm)\n100;5;6\n0;7;8\n",
        "target,run1,run2 / 0 100 / ↑ 1 3 / ↓ 7 5 / ↑ 2 4 / ↓ 8 6 / ");
    row("directions in a column", "Target (mm);Dir;1 (µm);2 (µm)\n0;+;1;2\n100;+;3;4\n0;-;5;6\n100;-;7;8\n",
        "target,direction,run1,run2 / 0 100 / ↑ 1 3 / ↓ 5 7 / ↑ 2 4 / ↓ 6 8 / ");
    row("list",
        "i;target (mm);direction;run;deviation (µm)\n1;0;+;1;1\n2;100;+;1;2\n3;0;-;1;3\n4;100;-;1;4\n",
        "ignored,target,direction,number,deviation / 0 100 / ↑ 1 2 / ↓ 3 4 / ");
    row("list with ±1",
        "target (mm);direction;run;deviation (µm)\n0;1;1;1\n100;1;1;2\n100;-1;1;4\n0;-1;1;3\n",
        "target,direction,number,deviation / 0 100 / ↑ 1 2 / ↓ 3 4 / ");
    row("stack without a word", "Target (mm);Dev (µm)\n0;1\n100;2\n200;3\n0;5\n100;6\n200;7\n",
        "target,deviation / 0 100 200 / ↑ 1 2 3 / ↓ 5 6 7 / directions");
    row("there and back", "Target (mm);Dev (µm)\n0;1\n100;2\n200;3\n200;7\n100;6\n0;5\n",
        "target,deviation / 0 100 200 / ↑ 1 2 3 / ↓ 5 6 7 / ");
    row("group headings", "P (mm);Aller;;Retour;\n(mm);1 (µm);2 (µm);1 (µm);2 (µm)\n0;1;2;5;6\n100;3;4;7;8\n",
        "target,run+1,run+2,run-1,run-2 / 0 100 / ↑ 1 3 / ↓ 5 7 / ↑ 2 4 / ↓ 6 8 / ");
    row("across", "Run;0;100;200\n1 ↑ (µm);1;2;3\n1 ↓ (µm);4;5;6\n",
        "ignored,run,run,run / 0 100 200 / ↑ 1 2 3 / ↓ 4 5 6 / content positionUnit");
    row("across with a mean", "Run (mm);0;100;200\n1 ↑ (µm);1;2;3\n1 ↓ (µm);4;5;6\nMean;2.5;3.5;4.5\n",
        "ignored,run,run,run / 0 100 200 / ↑ 1 2 3 / ↓ 4 5 6 / ");
    row("across with another line", "Run (mm);0;100;200\n1 ↑ (µm);1;2;3\n1 ↓ (µm);4;5;6\nWxyz;9;9;9\n",
        "ignored,run,run,run / 0 100 200 / ↑ 1 2 3 / ↓ 4 5 6 / unread");
    // Runs that headings do not call by one name.
    row("a run of another name", "P (mm);Error 1 (µm);Wxyz 2 (µm);Error 3 (µm)\n0;1;2;3\n100;4;5;6\n",
        "target,deviation1,ignored,deviation3 / 0 100 / ↑ 1 4 / ↓ 3 6 / columns directions");
    row("all runs of two names", "P (mm);+;Dev 1 (µm);Foo 2 (µm)\n0;+;1;2\n100;+;3;4\n0;-;5;6\n100;-;7;8\n",
        "target,direction,deviation1,ignored / 0 100 / ↑ 1 3 / ↓ 5 7 / columns");
    row("a title over two columns without the last cell",
        ";Aller;;Retour\nP (mm);1 (µm);2 (µm);1 (µm);2 (µm)\n0;1;2;5;6\n100;3;4;7;8\n",
        "target,run+1,run+2,run-1,run-2 / 0 100 / ↑ 1 3 / ↓ 5 7 / ↑ 2 4 / ↓ 6 8 / ");
    row("abbreviated group headings",
        ";Fwd;;Rev;\nP;1;2;1;2\n(mm);(µm);(µm);(µm);(µm)\n0;1;2;5;6\n100;3;4;7;8\n",
        "target,run+1,run+2,run-1,run-2 / 0 100 / ↑ 1 3 / ↓ 5 7 / ↑ 2 4 / ↓ 6 8 / ");
    row("runs over directions",
        ";Run 1;;Run 2;\nP (mm);Fwd (µm);Rev (µm);Fwd (µm);Rev (µm)\n0;1;5;2;6\n100;3;7;4;8\n",
        "target,run+1,run-1,run+2,run-2 / 0 100 / ↑ 1 3 / ↓ 5 7 / ↑ 2 4 / ↓ 6 8 / ");
    row("dashes beneath what has no unit", "Pt;P;1 ↑;1 ↓;Foo\n-;mm;µm;µm;-\n1;0;1;5;9\n2;100;3;7;8\n",
        "ignored,target,run+1,run-1,ignored / 0 100 / ↑ 1 3 / ↓ 5 7 / ");
    row("a hyphen in a counter", "Lfd.-Nr.;P (mm);1 + (µm);1 - (µm)\n1;0;1;5\n2;100;3;7\n",
        "ignored,target,run+1,run-1 / 0 100 / ↑ 1 3 / ↓ 5 7 / ");
    row("titles of runs, half of them understood",
        "Wxyz 1 out\nP (mm);Dev (µm)\n0;1\n100;2\n\nback 1\nP (mm);Dev (µm)\n0;5\n100;6\n\nout "
        "2\nP (mm);Dev (µm)\n0;3\n100;4\n\nWxyz 2 - back\nP (mm);Dev (µm)\n0;7\n100;8\n",
        "target,deviation / 0 100 / ↑ 1 2 / ↓ 5 6 / ↑ 3 4 / ↓ 7 8 / directions");
    row("a dash before the unit", "Consigne / mm;approche + / µm;approche - / µm\n0;1;5\n100;3;7\n",
        "target,run+,run- / 0 100 / ↑ 1 3 / ↓ 5 7 / ");
    row("more runs there than back", "P (mm);1 ↑ (µm);2 ↑ (µm);1 ↓ (µm)\n0;1;2;5\n100;3;4;7\n",
        "target,run+1,run+2,run-1 / 0 100 / ↑ 1 3 / ↓ 5 7 / ↑ 2 4 / unequalRuns");
    // Markdown and other tables beside.
    row("Markdown", "| P (mm) | 1↑ (µm) | 1↓ (µm) |\n| --- | ---: | ---: |\n| 0 | 1 | 2 |\n| 100 | 3 | 4 |\n",
        "ignored,target,run+1,run-1,ignored / 0 100 / ↑ 1 3 / ↓ 2 4 / ");
    row("another table below",
        "P (mm);1↑ (µm);1↓ (µm)\n0;1;2\n100;3;4\n200;5;6\n\nNo.;Feed;Power\n1;500;3\n2;600;4\n",
        "target,run+1,run-1 / 0 100 200 / ↑ 1 3 5 / ↓ 2 4 6 / table");
    // Nothing is read half.
    row("a broken number", "P (mm);1↑ (µm);1↓ (µm)\n0;1;2\n100;3,,5;4\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 – / ↓ 2 4 / unread");
    row("thousands in targets", "P (mm);1↑ (µm);1↓ (µm)\n0,5;1,5;2,5\n1.250,5;3,5;4,5\n500,5;3,5;4,5\n",
        "target,run+1,run-1 / 0.5 500.5 1250.5 / ↑ 1.5 3.5 3.5 / ↓ 2.5 4.5 4.5 / ");
    row("a column without heading", "P (mm);1↑ (µm);1↓ (µm);\n0;1;2;7.5\n100;3;4;7.25\n",
        "target,run+1,run-1,ignored / 0 100 / ↑ 1 3 / ↓ 2 4 / columns columns");
    row("no direction beside directions", "P (mm);Dev 1↑ (µm);Dev 1↓ (µm);Dev (µm)\n0;1;2;7\n100;3;4;8\n",
        "target,deviation+1,deviation-1,ignored / 0 100 / ↑ 1 3 / ↓ 2 4 / columns columns");
    // Pages, comments and titles between the rows: the runs go on.
    row("headings again on the next page",
        "P (mm);↑ (µm);↓ (µm)\n0;1;5\n100;2;6\n\nPage 2 of 2\nP (mm);↑ (µm);↓ (µm)\n200;3;7\n300;4;8\n",
        "target,run+,run- / 0 100 200 300 / ↑ 1 2 3 4 / ↓ 5 6 7 8 / ");
    row("pages of falling targets",
        "P (mm);↑ (µm);↓ (µm)\n300;4;8\n200;3;7\n\nP (mm);↑ (µm);↓ (µm)\n100;2;6\n\nP (mm);↑ (µm);↓ "
        "(µm)\n0;1;5\n",
        "target,run+,run- / 0 100 200 300 / ↑ 1 2 3 4 / ↓ 5 6 7 8 / ");
    row("a comment between the rows", "P (mm);↑ (µm);↓ (µm)\n0;1;5\n# door opened\n100;2;6\n200;3;7\n",
        "target,run+,run- / 0 100 200 / ↑ 1 2 3 / ↓ 5 6 7 / ");
    row("a line of text between headings and rows",
        "Posición (mm);Error avance 1 (µm);Error retroceso 1 (µm)\n* puerta abierta 2\n0;1;5\n100;2;6\n",
        "target,deviation+1,deviation-1 / 0 100 / ↑ 1 2 / ↓ 5 6 / ");
    row("pages of both directions",
        "↑\nP (mm);1 (µm)\n0;1\n100;2\n\n↑\nP (mm);1 (µm)\n200;3\n\n↓\nP (mm);1 (µm)\n200;7\n100;6\n\n↓\nP "
        "(mm);1 (µm)\n0;5\n",
        "target,run1 / 0 100 200 / ↑ 1 2 3 / ↓ 5 6 7 / ");
    row("blocks at other targets",
        "P (mm);↑ (µm);↓ (µm)\n0;1;5\n100;2;6\n\nP (mm);↑ (µm);↓ (µm)\n50;3;7\n70;4;8\n",
        "target,run+,run- / 0 50 70 100 / ↑ 1 – – 2 / ↓ 5 – – 6 / ↑ – 3 4 – / ↓ – 7 8 – / layout");
    row("a tolerance below the headings", "P (mm);1↑ (µm);1↓ (µm)\nTolerance;8;8\n0;1;5\n100;2;6\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 2 / ↓ 5 6 / ");
    row("a temperature above the headings",
        "Date;12/03/2024\nTemperature;20.3 °C\nNo.;Position [mm];↑ [µm]\n1;0;1\n2;100;2\n",
        "ignored,target,run+ / 0 100 / ↑ 1 2 / sensor Temperature – 20.3 / ");
    row("a temperature with its unit beside",
        "Temperatur;20,3;°C\nSoll [mm];↑ 1 [µm];↑ 2 [µm]\n0;1;5\n100;2;6\n",
        "target,run+1,run+2 / 0 100 / ↑ 1 2 / ↑ 5 6 / sensor Temperatur – 20.3 / ");
    row("more headings than columns of numbers",
        "P (mm);forward (µm);;backward (µm);;;\n;1;Run 2;1;2;;Mean\n0;1;2;3;4\n100;5;6;7;8\n",
        "target,run+1,run+2,run-1,run-2 / 0 100 / ↑ 1 5 / ↓ 3 7 / ↑ 2 6 / ↓ 4 8 / ");
    // Each direction at its own targets.
    row("targets of both directions",
        "Target ↑ (mm);Dev ↑ (µm);Target ↓ (mm);Dev ↓ (µm)\n0;1;200;7\n100;2;100;6\n200;3;0;5\n",
        "target,deviation+,target,deviation- / 0 100 200 / ↑ 1 2 3 / ↓ 5 6 7 / ");
    row("the same targets again",
        "Target (mm);Dev ↑ (µm);Target (mm);Dev ↓ (µm)\n0;1;0;5\n100;2;100;6\n200;3;200;7\n",
        "target,deviation+,ignored,deviation- / 0 100 200 / ↑ 1 2 3 / ↓ 5 6 7 / ");
    // Several axes, called by the titles of their blocks.
    row("two axes in blocks",
        "Axis X\nP (mm);↑ (µm);↓ (µm)\n0;1;5\n100;2;6\n\nAxis Y\nP (mm);↑ (µm);↓ (µm)\n0;3;7\n100;4;8\n",
        "target,run+,run- / 0 100 / ↑ 1 2 / ↓ 5 6 / axis");
    row("an axis that is a letter of directions",
        "Soll (mm);V pos. Richtung 1 (µm);V neg. Richtung 1 (µm)\n0;1;5\n100;2;6\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 2 / ↓ 5 6 / ");
    // Arrows made of signs, units by their part, quotes around decimal commas.
    row("arrows of two signs", "Run;Direction;P (mm);Dev (µm)\n1;->;0;1\n1;->;100;2\n1;<-;100;6\n1;<-;0;5\n",
        "number,direction,target,deviation / 0 100 / ↑ 1 2 / ↓ 5 6 / ");
    for (const char *unit : {"1/1000 mm", "0.001 mm", "0,001 mm", "10^-3 mm", "10-3 mm", "10⁻³ mm"})
        QTest::newRow(qPrintable(QString("in %1").arg(unit)))
            << QByteArray("P (mm);↑ 1 (") + unit + ");↓ 1 (" + unit + ")\n0;0.1;0.5\n100;0.2;0.6\n"
            << QString("target,run+1,run-1 / 0 100 / ↑ 0.1 0.2 / ↓ 0.5 0.6 / ");
    row("in a part that is not known", "P (mm);↑ 1 (1/100 mm);↓ 1 (1/100 mm)\n0;0.1;0.5\n100;0.2;0.6\n",
        "target,run+1,run-1 / 0 100 / ↑ 0.1 0.2 / ↓ 0.5 0.6 / content unit");
    // What makes another unit of the one that stands there.
    for (const char *unit :
         {"tenths of µm", "Zehntel µm", "µm x 10", "µm/m", "hundredths mm", "centièmes de mm", "1e-3 mm",
          "E-3 mm", "mm/1000", "mm ×10⁻³", "mm × 1000", "centesimi di mm", "décimas de µm", "µm*10"})
        for (const char *table : {"P (mm);Dev ↑ 1 (%);Dev ↓ 1 (%)\n0;0.1;0.5\n100;0.2;0.6\n",
                                  "P (mm);Dev ↑ 1 [%];Dev ↓ 1 [%]\n0;0.1;0.5\n100;0.2;0.6\n",
                                  "P;Dev ↑ 1;Dev ↓ 1\n[mm];[%];[%]\n0;0.1;0.5\n100;0.2;0.6\n"}) {
            const QByteArray text = QByteArray(table).replace('%', unit);
            QTest::newRow(qPrintable(QString("scaled: %1").arg(QString(text).left(40).simplified())))
                << text << QString("target,deviation+1,deviation-1 / 0 100 / ↑ 0.1 0.2 / ↓ 0.5 0.6 / unit");
        }
    // Where the axis comes from is the other way, and asked.
    for (const char *from : {"approach from", "von", "depuis", "desde", "dal"})
        QTest::newRow(qPrintable(QString("from: %1").arg(from)))
            << QByteArray("P (mm);") + from + " - 1 (µm);" + from + " + 1 (µm)\n0;1;5\n100;2;6\n"
            << QString("target,run+1,run-1 / 0 100 / ↑ 1 2 / ↓ 5 6 / directions");
    row("titles that say where the axis comes from",
        "Run 1 approach from −\nP (mm);Dev (µm)\n0;1\n100;2\n\n"
        "Run 1 approach from +\nP (mm);Dev (µm)\n100;6\n0;5\n",
        "target,deviation / 0 100 / ↑ 1 2 / ↓ 5 6 / directions");
    row("from and to", "P (mm);from - to + 1 (µm);from + to - 1 (µm)\n0;1;5\n100;2;6\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 2 / ↓ 5 6 / directions");
    // A dash between words is none of direction where a word says it.
    row("titles with dashes",
        "Cycle 1 - aller\nP (mm);Dev (µm)\n0;1\n100;2\n\nCycle 1 - retour\nP (mm);Dev (µm)\n100;6\n0;5\n\n"
        "Cycle 2 - +\nP (mm);Dev (µm)\n0;3\n100;4\n\nCycle 2 - -\nP (mm);Dev (µm)\n100;8\n0;7\n",
        "target,deviation / 0 100 / ↑ 1 2 / ↓ 5 6 / ↑ 3 4 / ↓ 7 8 / ");
    // Short words that can mean nothing else.
    row("pos. and neg. Richtung", "Soll (mm);1 pos. Richtung (µm);1 neg. Richtung (µm)\n0;1;5\n100;2;6\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 2 / ↓ 5 6 / ");
    row("lines of pos. and neg. Richtung",
        "Soll (mm);0;100\npos. Richtung 1 (µm);1;2\nneg. Richtung 1 (µm);5;6\n",
        "ignored,run,run / 0 100 / ↑ 1 2 / ↓ 5 6 / ");
    for (const auto &[up, down] :
         {std::pair("↑", "↓"), std::pair("⇑", "⇓"), std::pair("↗", "↘"), std::pair("→", "←"),
          std::pair("-->", "<--"), std::pair("->", "<-"), std::pair(">>", "<<"), std::pair("»", "«")}) {
        QTest::newRow(qPrintable(QString("arrows %1").arg(up)))
            << QByteArray("Target (mm);Dev") + up + "1 (µm);Dev" + down + "1 (µm)\n0;1;5\n100;2;6\n"
            << QString("target,deviation+1,deviation-1 / 0 100 / ↑ 1 2 / ↓ 5 6 / ");
    }
    row("an angle measured along a linear axis",
        "Target (mm);Run 1 (µm);Pitch angle (arcsec)\n0;1;9\n100;2;8\n200;4;9\n",
        "target,run1,ignored / 0 100 200 / ↑ 1 2 4 / directions");
    row("an angle before the targets", "Angle (°);Target (mm);Run 1 (µm)\n30;0;1\n30;100;2\n30;200;4\n",
        "ignored,target,run1 / 0 100 200 / ↑ 1 2 4 / directions");
    // Rotary axes.
    row("a measured angle beside the axis",
        "C (deg);Measured angle (°);Dir\n0;0.001;+\n90;90.002;+\n90;90.006;-\n0;0.005;-\n",
        "target,actual,direction / 0 90 / ↑ 0.001 0.002 / ↓ 0.005 0.006 / ");
    row("angles measured clockwise, across",
        "Table angle (°);0;90;180\nMeasured CW 1 (°);0.001;90.002;180.003\nMeasured CCW 1 "
        "(°);0.005;90.006;180.007\n",
        "ignored,run,run,run / 0 90 180 / ↑ 0.001 0.002 0.003 / ↓ 0.005 0.006 0.007 / directions");
    row("angular deviations with signs",
        "Position angulaire (°);Écart angulaire + 1 (mdeg);Écart angulaire - 1 (mdeg)\n0;1;5\n90;2;6\n",
        "target,deviation+1,deviation-1 / 0 90 / ↑ 0.001 0.002 / ↓ 0.005 0.006 / ");
    row("words of one piece",
        "Sollwinkel (°);Winkelabweichung ↑1 (mdeg);Winkelabweichung ↓1 (mdeg)\n0;1;5\n90;2;6\n",
        "target,deviation+1,deviation-1 / 0 90 / ↑ 0.001 0.002 / ↓ 0.005 0.006 / ");
    // A word of direction that nobody knows beside one that is known: no line is lost.
    row("one unknown word of direction, the way back falling",
        "Target (mm);Dev "
        "(µm);Dir\n0;1;fram\n100;2;fram\n200;3;fram\n200;7;backward\n100;6;backward\n0;5;backward\n",
        "target,deviation,direction / 0 100 200 / ↑ 1 2 3 / ↓ 5 6 7 / directions");
    row("one unknown word of direction, both rising",
        "Target (mm);Dev "
        "(µm);Dir\n0;1;forward\n100;2;forward\n200;3;forward\n0;5;aftur\n100;6;aftur\n200;7;aftur\n",
        "target,deviation,direction / 0 100 200 / ↑ 1 2 3 / ↓ 5 6 7 / directions");
    row("one unknown word of direction, at each target in turn",
        "Target (mm);Dev "
        "(µm);Dir\n0;1;forward\n0;5;aftur\n100;2;forward\n100;6;aftur\n200;3;forward\n200;7;aftur\n",
        "target,deviation,direction / 0 100 200 / ↑ 1 2 3 / ↓ 5 6 7 / directions");
    row("pos. direction beside reverse", "Target (mm);pos. direction 1 (µm);reverse 1 (µm)\n0;1;5\n100;2;6\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 2 / ↓ 5 6 / ");
    row("readings of pos. direction beside reverse",
        "Target (mm);Run 1 pos. direction (mm);Run 1 reverse (mm)\n0;0.001;0.005\n100;100.002;100.006\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 2 / ↓ 5 6 / content");
    row("a column of directions named Pos. direction",
        "Target (mm);Deviation (µm);Pos. direction\n0;1;+\n100;2;+\n100;6;-\n0;5;-\n",
        "target,deviation,direction / 0 100 / ↑ 1 2 / ↓ 5 6 / ");
    row("pos and neg alone", "Target (mm);pos 1 (µm);neg 1 (µm)\n0;1;5\n100;2;6\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 2 / ↓ 5 6 / directions");
    // Statistics by the letters of the standard, means without a number.
    row("letters with directions",
        "P (mm);↑1 (µm);↑2 (µm);M↑;s↑;R↑;2s↑;↓1 (µm);↓2 (µm);M↓;s↓;R↓;2s↓\n"
        "0;1;2;1.5;1;4;2;5;6;5.5;1;4;2\n100;3;4;3.5;1;4;2;7;8;7.5;1;4;2\n",
        "target,run+1,run+2,statistic,statistic,statistic,statistic,run-1,run-2,statistic,statistic,"
        "statistic,"
        "statistic / 0 100 / ↑ 1 3 / ↓ 5 7 / ↑ 2 4 / ↓ 6 8 / ");
    row("a direction without a number beside runs",
        "P (mm);↑1 (µm);↑2 (µm);↑ (µm);↓1 (µm);↓2 (µm);↓ (µm)\n0;1;2;1.5;5;6;5.5\n100;3;4;3.5;7;8;7.5\n",
        "target,run+1,run+2,ignored,run-1,run-2,ignored / 0 100 / ↑ 1 3 / ↓ 5 7 / ↑ 2 4 / ↓ 6 8 / columns "
        "columns");
    row("a line of means by another word", "P (mm);↑1 (µm);↓1 (µm)\n0;1;5\n100;3;7\nDurchschnitt;2;6\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 3 / ↓ 5 7 / ");
    row("a line without a target", "P (mm);↑1 (µm);↓1 (µm)\n0;1;5\n100;3;7\n;2;6\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 3 / ↓ 5 7 / unread");
    row("negative numbers in brackets", "P (mm);↑1 (µm);↓1 (µm)\n0;(1);5\n100;(3);7\n200;5;(6)\n",
        "target,ignored,run-1 / 0 100 / ↓ 5 7 / columns columns unread");
    // Targets twice in a run.
    row("a target twice", "P (mm);↑1 (µm);↓1 (µm)\n0;1;5\n100;2;6\n100;3;7\n200;4;8\n",
        "target,run+1,run-1 / 0 100 200 / ↑ 1 2 – / ↓ 5 6 – / ↑ – 3 4 / ↓ – 7 8 / layout");
    row("a target twice in a list",
        "Run;Direction;P (mm);Dev (µm)\n1;+;0;1\n1;+;100;2\n1;+;100;9\n1;-;0;5\n1;-;100;6\n1;-;100;8\n",
        "number,direction,target,deviation / 0 100 / ↑ 1 2 / ↓ 5 6 / ↑ – 9 / ↓ – 8 / layout");
    // Letters below a heading that names directions.
    for (const auto &[heading, up, down] :
         {std::tuple("Direction", "F", "R"), std::tuple("Richtung", "V", "R"), std::tuple("Sens", "A", "R"),
          std::tuple("Direction", "P", "N"), std::tuple("Approach", "from -", "from +")})
        QTest::newRow(qPrintable(QString("letters %1 and %2").arg(up, down)))
            << QByteArray("P (mm);") + heading + ";Dev (µm)\n0;" + down + ";5\n100;" + down + ";7\n0;" + up +
                   ";1\n100;" + up + ";3\n"
            << QString("target,direction,deviation / 0 100 / ↓ 5 7 / ↑ 1 3 / directions");
    // Blocks that may be tests of their own.
    row("before and after",
        "Before compensation\nP (mm);↑1 (µm);↓1 (µm)\n0;1;5\n100;2;6\n\n"
        "After compensation\nP (mm);↑1 (µm);↓1 (µm)\n0;3;7\n100;4;8\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 2 / ↓ 5 6 / state");
    row("blocks of the same runs without titles",
        "P (mm);↑1 (µm);↓1 (µm)\n0;1;5\n100;2;6\n\nP (mm);↑1 (µm);↓1 (µm)\n0;3;7\n100;4;8\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 2 / ↓ 5 6 / ↑ 3 4 / ↓ 7 8 / layout");
    row("blocks of runs by their titles",
        "Run 1\nP (mm);↑ (µm);↓ (µm)\n0;1;5\n100;2;6\n\nRun 2\nP (mm);↑ (µm);↓ (µm)\n0;3;7\n100;4;8\n",
        "target,run+,run- / 0 100 / ↑ 1 2 / ↓ 5 6 / ↑ 3 4 / ↓ 7 8 / ");
    // Near zero along a long axis, in units that are stated: no positions.
    row("millimetres without a word", "P (mm);↑1 (mm);↓1 (mm)\n0;0.001;0.005\n100;0.002;0.006\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 2 / ↓ 5 6 / ");
    row("millimetres of a short axis without a word", "P (mm);↑1 (mm);↓1 (mm)\n0;0.01;0.05\n0.1;0.02;0.06\n",
        "target,run+1,run-1 / 0 0.1 / ↑ 10 20 / ↓ 50 60 / content");
    row("tabs between cells with blanks in them",
        "Máquina: Mazak VTC-800\nOperario: Meier\nTemperatura: 20,3 °C\n\n"
        "Posición objetivo [mm]\t-250,00\t-224,43\t-199,56\n"
        "Error de posición ida 1 [µm]\t2,0\t1,7\t2,9\nError de posición vuelta 1 [µm]\t-2,2\t-1,0\t-0,9\n",
        "ignored,run,run,run / -250 -224.43 -199.56 / ↑ 2 1.7 2.9 / ↓ -2.2 -1 -0.9 / sensor Temperatura "
        "– "
        "20.3 / ");
    row("few decimals among whole numbers", "P (mm);↑1 (µm);↓1 (µm)\n0;1;5\n100;3.5;7\n200;4;8\n300;4;9\n",
        "target,run+1,run-1 / 0 100 200 300 / ↑ 1 3.5 4 4 / ↓ 5 7 8 9 / ");
    // What is measured along an axis and is no position.
    for (const char *title : {"Straightness of X", "Geradheit X-Achse", "Rectitude de l'axe X",
                              "Yaw (Gieren)", "Rettilineità asse X", "Rectitud eje X"})
        QTest::newRow(qPrintable(QString("no positions: %1").arg(title)))
            << QByteArray(title) + "\nP (mm);↑1 (µm);↓1 (µm)\n0;1;5\n100;2;6\n"
            << QString("target,run+1,run-1 / 0 100 / ↑ 1 2 / ↓ 5 6 / kind");
    row("a straight line", "Straight line of X, Yawata\nP (mm);↑1 (µm);↓1 (µm)\n0;1;5\n100;2;6\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 2 / ↓ 5 6 / ");
    row("µm above positions", "Unit: µm\nTarget;Actual ↑ 1;Actual ↓ 1\n0;0.001;0.005\n100;100.002;100.006\n",
        "target,actual+1,actual-1 / 0 100 / ↑ 1 2 / ↓ 5 6 / positionUnit unit");
    row("mm above positions", "Unit: mm\nTarget;Actual ↑ 1;Actual ↓ 1\n0;0.001;0.005\n100;100.002;100.006\n",
        "target,actual+1,actual-1 / 0 100 / ↑ 1 2 / ↓ 5 6 / ");
    // As many millimetres before zero as after it.
    row("positions about zero", "Target;Actual ↑ 1;Actual ↓ 1\n-500;-499.999;-499.997\n500;499.99;499.992\n",
        "target,actual+1,actual-1 / -500 500 / ↑ 1 -10 / ↓ 3 -8 / positionUnit unit");
    row("positions about zero without a word",
        "P (mm);↑1 (mm);↓1 (mm)\n-500;-499.999;-499.997\n500;499.99;499.992\n",
        "target,run+1,run-1 / -500 500 / ↑ 1 -10 / ↓ 3 -8 / content");
    // Thousands or decimals of a small axis.
    row("1,000 beside 0", "P (mm);↑1 (µm);↓1 (µm)\n0;1;5\n1,000;2;6\n2,000;3;7\n",
        "target,run+1,run-1 / 0 1 2 / ↑ 1 2 3 / ↓ 5 6 7 / decimalMark");
    row("1,000 beside 0,000", "P (mm);↑1 (µm);↓1 (µm)\n0,000;1;5\n1,000;2;6\n2,000;3;7\n",
        "target,run+1,run-1 / 0 1 2 / ↑ 1 2 3 / ↓ 5 6 7 / ");
    row("100.000 in mm", "P (mm);↑1 (µm);↓1 (µm)\n100.000;1;5\n200.000;2;6\n300.000;3;7\n",
        "target,run+1,run-1 / 100 200 300 / ↑ 1 2 3 / ↓ 5 6 7 / ");
    row("a counter under its sign", "#;Soll (mm);↑1 (µm);↓1 (µm)\n1;0;1;5\n2;100;2;6\n3;250;3;7\n",
        "ignored,target,run+1,run-1 / 0 100 250 / ↑ 1 2 3 / ↓ 5 6 7 / ");
    row("a counter under its sign and groups above",
        ";;↑ (µm);↓ (µm)\n#;Soll (mm);Lauf 1;Lauf 1\n1;0;1;5\n2;100;2;6\n3;250;3;7\n",
        "ignored,target,run+1,run-1 / 0 100 250 / ↑ 1 2 3 / ↓ 5 6 7 / ");
    row("quoted decimal commas",
        "\"P (mm)\",\"↑ (µm)\",\"↓\n(µm)\"\n\"0,00\",\"1,1\",\"5,5\"\n\"100,05\",\"2,2\",\"6,6\"\n",
        "target,run+,run- / 0 100.05 / ↑ 1.1 2.2 / ↓ 5.5 6.6 / ");
    // Numbers that look wrong.
    row("millimetres off", "P (mm);Dev ↑ (mm);Dev ↓ (mm)\n0;1.5;2.5\n100;3.5;4.5\n",
        "target,deviation+,deviation- / 0 100 / ↑ 1500 3500 / ↓ 2500 4500 / large");
    row("nothing but zeros", "P (mm);Dev ↑ (µm);Dev ↓ (µm)\n0;0;1\n100;0;2\n",
        "target,deviation+,deviation- / 0 100 / ↑ 0 0 / ↓ 1 2 / zeros");
    row("targets again", "P (mm);Dev ↑1 (µm);Dev ↓1 (µm)\n0;0;1\n100;100;2\n200;200;3\n",
        "target,deviation+1,deviation-1 / 0 100 200 / ↑ 0 100 200 / ↓ 1 2 3 / equalsTargets");
    row("one run that is none",
        "P (mm);Dev ↑1 (µm);Dev ↓1 (µm);Dev ↑2 (µm);Dev ↓2 (µm)\n0;1;1;2;-300\n100;2;3;4;400\n",
        "target,deviation+1,deviation-1,deviation+2,deviation-2 / 0 100 / ↑ 1 2 / ↓ 1 3 / ↑ 2 4 / ↓ -300 400 "
        "/ spread");
    // Circles.
    row("ballbar with its nominal radius",
        "angle,radius_nominal,radius_measured,deviation\n0,100,100.001,1\n90,100,100.002,2\n180,100,100.001,"
        "1\n270,100,100,0\n",
        "angle,nominal,radius,ignored / ISO 230-4:2005 XY R 100 mm F – / ccw polar 4: 0:1 90:2 180:1 270:0 / "
        "positionUnit unit");
    row("phase and radius", "Phase (deg), Radius\n0, 100.001\n90, 100.002\n180, 100.001\n270, 100\n",
        "angle,radius / ISO 230-4:2005 XY R 100 mm F – / ccw polar 4: 0:1 90:2 180:1 270:0 / nominalRadius "
        "unit");
    row("angle and deviation, no radius", "Angle (°);Deviation (µm)\n0;1\n90;2\n180;1\n270;0\n",
        "angle,deviation / ISO 230-4:2005 XY R 150 mm F – / ccw polar 4: 0:1 90:2 180:1 270:0 / "
        "nominalRadius");
    row("angle beside x and y",
        "angle;x (mm);y (mm)\n0;100.001;0\n90;0;100.002\n180;-100.001;0\n270;0;-100\n",
        "ignored,x,y / ISO 230-4:2005 XY R 100 mm F – / ccw polar 4: 0:1 90:2 180:1 270:0 / kind "
        "nominalRadius");
    row("the plane ZX", "Piano: ZX\nZ (mm);X (mm)\n100.001;0\n0;100.002\n-100.001;0\n0;-100\n",
        "x,y / ISO 230-4:2005 ZX R 100 mm F – / ccw polar 4: 0:1 90:2 180:1 270:0 / kind nominalRadius");
    row("the plane ZX, its columns turned",
        "Plane: ZX\nX (mm);Z (mm)\n0;100.001\n100.002;0\n0;-100.001\n-100;0\n",
        "y,x / ISO 230-4:2005 ZX R 100 mm F – / ccw polar 4: 0:1 90:2 180:1 270:0 / kind nominalRadius");
    row("a plane without X", "Y (mm);Z (mm)\n100.001;0\n0;100.002\n-100.001;0\n0;-100\n",
        "x,y / ISO 230-4:2005 YZ R 100 mm F – / ccw polar 4: 0:1 90:2 180:1 270:0 / kind nominalRadius");
    for (const char *words :
         {"Gegen den Uhrzeigersinn", "sens inverse des aiguilles d'une montre", "anti horaire",
          "senso antiorario", "contrario a las agujas del reloj", "SAH", "counter clockwise"})
        QTest::newRow(words)
            << QByteArray(words) + "\nAngle (°);Deviation (µm)\n270;0\n180;1\n90;2\n0;1\n"
            << QString("angle,deviation / ISO 230-4:2005 XY R 150 mm F – / ccw polar 4: 0:1 90:2 "
                       "180:1 270:0 / nominalRadius sense");
    for (const char *words : {"Im Uhrzeigersinn", "sens des aiguilles d'une montre", "senso orario", "SH"})
        QTest::newRow(words)
            << QByteArray(words) + "\nAngle (°);Deviation (µm)\n0;1\n90;2\n180;1\n270;0\n"
            << QString("angle,deviation / ISO 230-4:2005 XY R 150 mm F – / cw polar 4: 270:0 180:1 "
                       "90:2 0:1 / nominalRadius sense");
    row("a sense in prose",
        "Radius: 80 mm\nRotary table turned clockwise before the test\nAngle (°);Deviation "
        "(µm)\n0;1\n90;2\n180;1\n270;0\n",
        "angle,deviation / ISO 230-4:2005 XY R 80 mm F – / ccw polar 4: 0:1 90:2 180:1 270:0 / ");
    row("deviations at nominal points",
        "Radius: 80 mm\nX nominal (mm);Y nominal (mm);Deviation (µm)\n80;0;1\n0;80;2\n-80;0;1\n0;-80;0\n",
        "x,y,deviation / ISO 230-4:2005 XY R 80 mm F – / ccw polar 4: 0:1 90:2 180:1 270:0 / ");
    row("two columns beside the angles, and no word for the sense",
        "Radius: 100 mm\nAngle (°);Deviation links (µm);Deviation rechts "
        "(µm)\n0;1;4\n90;2;5\n180;1;4\n270;0;3\n",
        "angle,deviation,deviation / ISO 230-4:2005 XY R 100 mm F – / ccw polar 4: 0:1 90:2 180:1 270:0 / "
        "ccw "
        "polar 4: 0:4 90:5 180:4 270:3 / columns");
    for (const char *label : {"Nominal radius: 100 mm", "Rayon nominal;100 mm", "Nennradius: 100 mm",
                              "Sollradius 100 mm", "Raggio nominale: 100,0 mm", "Radio nominal = 100 mm"})
        QTest::newRow(label)
            << QByteArray(label) + "\nAngle (°);Deviation (µm)\n0;1\n90;2\n180;1\n270;0\n"
            << QString("angle,deviation / ISO 230-4:2005 XY R 100 mm F – / ccw polar 4: 0:1 90:2 "
                       "180:1 270:0 / ");
    row("times of day beside places and what was measured there",
        "Nr.;Zeit;Messposition (mm);Istposition (mm);Abw. (µm)\n1;10:00:07;0;0.0023;2.3\n"
        "2;10:00:14;100;100.001;1\n3;10:00:21;200;200.002;2\n4;10:00:28;200;199.999;-1\n"
        "5;10:00:35;100;99.998;-2\n6;10:00:42;0;-0.003;-3\n",
        "ignored,ignored,target,actual,deviation / 0 100 200 / ↑ 2.3 1 2 / ↓ -3 -2 -1 / ");
    // Cells that say their unit.
    const char *const withUnits = "target,run+1,run-1 / 0 100 200 / ↑ 1.2 2.2 0.5 / ↓ 2.1 -3.1 4 / ";
    row("each number with its unit",
        "Target;Run 1 up;Run 1 down\n0 mm;1.2 µm;2.1 µm\n100 mm;2.2 µm;-3.1 µm\n200 mm;0.5 µm;4.0 µm\n",
        withUnits);
    row("some readings in mm, some in µm",
        "Target;Run 1 up;Run 1 down\n0 mm;1.2 µm;0.0021 mm\n100 mm;2.2 µm;-3.1um\n200 mm;0.0005 mm;4 µm\n",
        withUnits);
    row("units behind decimal commas",
        "Soll;Hin 1;Rück 1\n0,0 mm;1,2 µm;2,1 µm\n100,0 mm;2,2 µm;-3,1 µm\n200,0 mm;0,5 µm;4,0 µm\n",
        withUnits);
    row("units among blanks",
        "Target Up1 Down1\n0 mm 1.2 µm 2.1 µm\n100 mm 2.2 µm -3.1 µm\n200 mm 0.5 µm 4.0 µm\n", withUnits);
    row("units, and rows of statistics",
        "Target;Run 1 up;Run 1 down\n0 mm;1.2 µm;2.1 µm\n100 mm;2.2 µm;-3.1 µm\n200 mm;0.5 µm;4.0 µm\n"
        "Mean;1.3 µm;1 µm\n2s;0.3 µm;0.5 µm\n",
        withUnits);
    row("labels whose values have units",
        "Travel;500 mm\nRadius;100 mm;Step;5 mm\nTarget (mm);Run 1 up (µm);Run 1 down (µm)\n"
        "0;1.2;2.1\n100;2.2;-3.1\n200;0.5;4\n",
        withUnits);
    row("a number without a unit among others",
        "Target;Run 1 up;Run 1 down\n0 mm;1.2 µm;2.1 µm\n100 mm;2.2;-3.1 µm\n200 mm;0.5 µm;4.0 µm\n",
        "target,run+1,run-1 / 0 100 200 / ↑ 1.2 2.2 0.5 / ↓ 2.1 -3.1 4 / unit");
    row("the heading names another unit than the cells",
        "Target (mm);Run 1 up (mm);Run 1 down (µm)\n0;1.2 µm;2.1 µm\n100;2.2 µm;-3.1 µm\n200;0.5 µm;4 µm\n",
        "target,run+1,run-1 / 0 100 200 / ↑ 1.2 2.2 0.5 / ↓ 2.1 -3.1 4 / unit");
    row("units of targets across", "Run;0 mm;100 mm;200 mm\n1 ↑ (µm);1.2;2.2;0.5\n1 ↓ (µm);2.1;-3.1;4\n",
        "ignored,run,run,run / 0 100 200 / ↑ 1.2 2.2 0.5 / ↓ 2.1 -3.1 4 / ");
    row("units of targets across, and of readings",
        "Run\t0 mm\t100 mm\t200 mm\n1 ↑\t1.2 µm\t2.2 µm\t0.5 µm\n1 ↓\t2.1 µm\t-3.1 µm\t4 µm\n",
        "ignored,run,run,run / 0 100 200 / ↑ 1.2 2.2 0.5 / ↓ 2.1 -3.1 4 / ");
    row("first, second, third run", "Target (mm);1°;2°\n0;1.2;2.1\n100;2.2;-3.1\n200;0.5;4\n",
        "target,run1,run2 / 0 100 200 / ↑ 1.2 2.2 0.5 / ↓ 2.1 -3.1 4 / content directions unit");
    row("a unit that nobody knows", "Target;Up 1;Down 1\n0;1.2 ell;2.1 ell\n100;2.2 ell;3 ell\n", "refused");
    row("degrees, minutes, seconds",
        "Target;Up 1;Down 1\n-0°30';-3.6\";7.2″\n12°30';1.8\";3.6″\n30°15'36\";0\";-1.8″\n",
        "target,run+1,run-1 / -0.5 12.5 30.26 / ↑ -0.001 0.0005 0 / ↓ 0.002 0.001 -0.0005 / ");
    row("degrees, minutes, seconds in quotation marks",
        "Target,Up 1,Down 1\n\"-0°30'0\"\"\",\"-3.6\"\"\",\"7.2\"\"\"\n"
        "\"12°30'0\"\"\",\"1.8\"\"\",\"3.6\"\"\"\n",
        "target,run+1,run-1 / -0.5 12.5 / ↑ -0.001 0.0005 / ↓ 0.002 0.001 / ");
    row("positions in degrees, minutes, seconds",
        "Soll;Ist 1 hin;Ist 1 rück\n0°00'00\";0°00'01,8\";-0°00'03,6\"\n"
        "90°00'00\";90°00'03,6\";89°59'58,2\"\n",
        "target,actual+1,actual-1 / 0 90 / ↑ 0.0005 0.001 / ↓ -0.001 -0.0005 / ");
    // Lists whose readings have targets of their own.
    for (const char *heading :
         {"Position (mm)", "Quota (mm)", "Axis position (mm)", "Punkt (mm)", "Soll (mm)"}) {
        const QByteArray name(heading);
        QTest::newRow(name + " twice, rising and falling")
            << name + ";1 ↑ (µm);" + name + ";1 ↓ (µm)\n0;1;200;2\n100;3;100;4\n200;5;0;6\n"
            << "target,run+1,target,run-1 / 0 100 200 / ↑ 1 3 5 / ↓ 6 4 2 / ";
    }
    row("another heading of places before the second direction",
        "Target (mm);1 ↑ (µm);Position (mm);1 ↓ (µm)\n0;1;200;2\n100;3;100;4\n200;5;0;6\n",
        "target,run+1,target,run-1 / 0 100 200 / ↑ 1 3 5 / ↓ 6 4 2 / columns");
    for (const char *label : {"2s", "±2s", "4 s", "2σ", "Ø"})
        QTest::newRow(qPrintable(QString("a footer of %1").arg(label)))
            << "Target (mm);Up 1 (µm);Down 1 (µm)\n0;1;2\n100;3;4\n" + QByteArray(label) + ";2.5;3.5\n"
            << "target,run+1,run-1 / 0 100 / ↑ 1 3 / ↓ 2 4 / ";
    row("signs above several columns", ";+;;-;\nTarget;1;2;1;2\nmm;µm;µm;µm;µm\n0;1;2;3;4\n100;5;6;7;8\n",
        "target,run+1,run+2,run-1,run-2 / 0 100 / ↑ 1 5 / ↓ 3 7 / ↑ 2 6 / ↓ 4 8 / ");
    row("signs of seconds in a row of units",
        "Target;Up 1;Down 1;Up 2\n°;\";\";\"\n0;3.6;7.2;1.8\n30;1.8;3.6;0\n",
        "target,run+1,run-1,run+2 / 0 30 / ↑ 0.001 0.0005 / ↓ 0.002 0.001 / ↑ 0.0005 0 / unequalRuns");
    row("outward and inward", "Target (mm);Outward 1 (µm);Inward 1 (µm)\n0;1;2\n100;3;4\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 3 / ↓ 2 4 / directions");
    row("a damaged number in two columns", "Target (mm);Dev ↑ (µm)\n0;1\n100;2x\n200;3\n",
        "target,deviation+ / 0 200 / ↑ 1 3 / unread");
    row("a damaged number in the first line", "Target (mm);↑ (µm);↓ (µm)\n0x;1;5\n100;2;6\n200;3;7\n",
        "target,run+,run- / 100 200 / ↑ 2 3 / ↓ 6 7 / unread");
    row("a letter for a digit", "Target (mm);↑ (µm)\n0;1\n1O0;2\n200;3\n",
        "target,run+ / 0 200 / ↑ 1 3 / unread");
    row("a damaged row of a compensation text",
        "Compensation spacing 50 mm\nNo.  Axis position  Combined\n1  0.0  0.0\n2  5x0.0  -2.5\n3  100.0  "
        "4.0\n",
        " / 0 100 / ↑ 0 -4 / unit unread");
    row("damaged names of readings",
        "TGT_DATA[1]=0\nTGT_DATA[2]=100\nREF_DATA_FWD[1,1]=0.001\nREF_DATA_FWD[2,1x=100.002\n"
        "REF_DxTA_BWD[1,1]=0.003\nREF_DATA_BWD[2,1]=100.004\n",
        " / 0 100 / ↑ 1 – / ↓ – 4 / unit unread");
    row("a gap among blanks",
        "Position Fwd1 Rev1 Fwd2 Rev2\n(mm) (um) (um) (um) (um)\n0 1 2 3 4\n100 5 6      7\n200 8 9 10 11\n",
        "target,run+1,run-1,run+2,run-2 / 0 200 / ↑ 1 8 / ↓ 2 9 / ↑ 3 10 / ↓ 4 11 / unread");
    row("places, deviations and the time of day",
        "Cota (mm);Error avance 1 (µm);Hora\n0;1;10:00:00\n100;2;10:00:05\n200;3;10:00:10\n",
        "target,deviation1,ignored / 0 100 200 / ↑ 1 2 3 / directions kind");
    row("labels with values in other units above",
        "Measured 2024-03-05;;\nPressure;1013.2;hPa\nHumidity;45;%\nTarget (mm);↑1 (µm);↓1 "
        "(µm)\n0;1;2\n100;3;4\n",
        "target,run+1,run-1 / 0 100 / ↑ 1 3 / ↓ 2 4 / ");
    row("a damaged unit above a run", "P (mm);1 ↑ (µm);2 ↑ (µm);3 ↑ (xµm)\n0;1;2;3\n100;4;5;6\n",
        "target,run+1,run+2,ignored / 0 100 / ↑ 1 4 / ↑ 2 5 / columns columns");
    row("a letter in the place of the delimiter",
        "Radius: 100 mm\nAngle (°);Deviation (µm)\n0;1\n90;2\n180x1\n270;0\n",
        "angle,deviation / ISO 230-4:2005 XY R 100 mm F – / ccw polar 3: 0:1 90:2 270:0 / unread");
    row("a sign in the place of a minus", "Target[mm] Dev[µm]\n0 1\n100 ~2.1\n200 3\n",
        "target,deviation / 0 200 / ↑ 1 3 / directions unread");
    row("a number in two pieces in a compensation text",
        "Compensation spacing 50 mm\nNo.  Axis position  Combined\n1  0.0  0.0\n2  5 0.0  -2.5\n3  100.0  "
        "4.0\n",
        " / 0 100 / ↑ 0 -4 / unit unread");
    row("words beside indexed values are no damage",
        "# UNIT : Unit for readings (optional, defaults to "
        "in)\nREF_PV=IOC:m0s2-Enc\nTGT_SET_PV=IOC:X1\nDEC=4\nUNIT=mm\nTGT_DATA[1]=0\nTGT_DATA[2]=100\n"
        "REF_DATA_FWD[1,1]=0.001\nREF_DATA_FWD[2,1]=100.002\n",
        " / 0 100 / ↑ 1 2 / ");
    row("readings whose name is damaged or cut off",
        "UNIT=mm\nTGT_DATA[1]=0\nTGT_DATA[2]=100\nREF_DATA_FWD[1,1]=0.001\nRE?_DATA_FWD[2,1]=100.002\nREF_"
        "DATA",
        " / 0 100 / ↑ 1 – / unread");
    row("tests named by their directions, positions of several instruments",
        "Forward test sequence\n\nj (cycle);Target(i,j) [mm];Motor(i,j) [mm];Encoder(i,j) [mm];x(i,j) (diff "
        "ref-tgt), [mm]\n1;0;0.001;0.5;0.001\n1;100;100.001;100.5;0.002\n2;0;0.001;0.5;0.003\n"
        "2;100;100.001;100.5;0.004\n\nBackward test sequence\n\nj (cycle);Target(i,j) [mm];Motor(i,j) [mm];"
        "Encoder(i,j) [mm];x(i,j) (diff ref-tgt), [mm]\n1;0;-0.001;0.5;-0.005\n1;100;99.999;100.5;-0.006\n"
        "2;0;-0.001;0.5;-0.007\n2;100;99.999;100.5;-0.008\n",
        "number,target,actual,actual,deviation / 0 100 / ↑ 1 2 / ↓ -5 -6 / ↑ 3 4 / ↓ -7 -8 / ");
    row("own targets, there and back",
        "Target (mm);Direction;Dev 1 (µm);Target (mm);Dev 2 (µm)\n0;+;1;0.5;5\n100;+;2;100.5;6\n"
        "100;-;3;100.5;7\n0;-;4;0.5;8\n",
        "target,direction,deviation1,target,deviation2 / 0 0.5 100 100.5 / ↑ 1 – 2 – / ↓ 4 – 3 – / "
        "↑ – 5 – 6 / ↓ – 8 – 7 / ");
    row("a column of targets without one",
        "Target (mm);Direction;Dev 1 (µm);Target (mm);Dev 2 (µm)\n0;+;1;;5\n100;+;2;;6\n",
        "target,direction,deviation1,ignored,deviation2 / 0 100 / ↑ 1 2 / ↑ 5 6 / columns");
    row("own targets that are none: a pass without a reading",
        "Target (mm);Direction;Dev 1 (µm);Target (mm);Dev 2 (µm)\n0;+;1;0.5;5\n100;+;2;100.5;6\n"
        "100;-;3;x;7\n0;-;4;x;8\n",
        "target,direction,deviation1,target,deviation2 / 0 0.5 100 100.5 / ↑ 1 – 2 – / ↓ 4 – 3 – / "
        "↑ – 5 – 6 / ↓ – – – – / layout unread");
    // Senses of rotation: which of them is positive is not known.
    for (const auto &[up, down] :
         std::vector<std::pair<QByteArray, QByteArray>>{{"CW", "CCW"},
                                                        {"Clockwise", "Counter-clockwise"},
                                                        {"Uhrzeigersinn", "Gegenuhrzeigersinn"},
                                                        {"Im Uhrzeigersinn", "Gegen den Uhrzeigersinn"},
                                                        {"Sens horaire", "Sens antihoraire"},
                                                        {"Horaire", "Antihoraire"},
                                                        {"Senso orario", "Senso antiorario"},
                                                        {"Sentido horario", "Sentido antihorario"}}) {
        const QByteArray heading = "Target (°);" + up + " 1 (°);" + down + " 1 (°);" + up + " 2 (°);" + down +
                                   " 2 (°)\n0;0.01;0.02;0.03;0.04\n90;0.02;0.03;0.04;0.05\n";
        QTest::newRow(up + " beside " + down)
            << heading
            << "target,run+1,run-1,run+2,run-2 / 0 90 / ↑ 0.01 0.02 / ↓ 0.02 0.03 / ↑ 0.03 0.04 / ↓ 0.04 "
               "0.05 / directions";
        QTest::newRow(up + " in a column")
            << "Position (°);Dir.;Deviation (°)\n0;" + up + ";0.01\n90;" + up + ";0.02\n90;" + down +
                   ";0.03\n0;" + down + ";0.04\n"
            << "target,direction,deviation / 0 90 / ↑ 0.01 0.02 / ↓ 0.04 0.03 / directions";
    }
    row("one sense alone", "Target (°);CW 1 (°);CW 2 (°)\n0;0.01;0.02\n90;0.02;0.03\n",
        "target,run+1,run+2 / 0 90 / ↑ 0.01 0.02 / ↑ 0.02 0.03 / directions");
    // Dates and times that a spreadsheet has made of readings.
    row("readings that became dates and times",
        "Target (mm);Forward (µm);Reverse (µm)\n0;1;2\n100;2026-01-05;3\n200;01:30;4\n",
        "target,ignored,run- / 0 100 200 / ↓ 2 3 4 / columns columns");
    row("readings that all became times",
        "Target (mm);Forward (µm);Reverse (µm)\n0;01:10;2\n100;01:20;3\n200;01:30;4\n",
        "target,ignored,run- / 0 100 200 / ↓ 2 3 4 / columns");
    // Merged cells of a heading.
    row("headings over several columns",
        "Target (mm);Forward (µm);;;Reverse (µm);;\n0;1;2;3;4;5;6\n100;2;3;4;5;6;7\n",
        "target,run+,run+,run+,run-,run-,run- / 0 100 / ↑ 1 2 / ↓ 4 5 / ↑ 2 3 / ↓ 5 6 / ↑ 3 4 / ↓ 6 7 / "
        "columns");
    row("headings over columns, not as many each",
        "Target (mm);Forward (µm);;;Reverse (µm);\n0;1;2;3;4;5\n100;2;3;4;5;6\n",
        "target,run+,ignored,ignored,run-,ignored / 0 100 / ↑ 1 2 / ↓ 4 5 / columns columns");
    // Statements directly above the headings, any number in a row.
    for (const char *above :
         {"Axis;Y;Feed;1500 mm/min", "Axis;Y;Operator;Ann", "Machine;ABC 40;Axis;Y",
          "Feed;1500 mm/min;Axis;Y", "Axis;Y;Temperature;19,5 °C", "Axis;Y;Feed;1500;", "Axis;Y;Time;09:45",
          "Axis;Y;Humidity;52 %", "Axis;Y;Pressure;998;hPa", "Axis: Y;Feed: 1500 mm/min",
          "Axe;Y;Vitesse;1500", "Achse;Y;Datum;12.03.2026"}) {
        QTest::newRow(qPrintable(QString("above the headings: ") + above))
            << QByteArray(above) +
                   "\nTarget (mm);Up 1 (µm);Down 1 (µm);Up 2 (µm);Down 2 (µm)\n0;1;2;3;4\n150;5;6;7;8\n"
            << "target,run+1,run-1,run+2,run-2 / 0 150 / ↑ 1 5 / ↓ 2 6 / ↑ 3 7 / ↓ 4 8 / " +
                   QString(QByteArray(above).contains("Temp") ? "sensor Temperature – 19.5 / " : "");
    }
    row("a condition above columns that name their runs",
        ";;Feed 900;;\nTarget (mm);Up 1 (µm);Down 1 (µm);Up 2 (µm);Down 2 (µm)\n0;1;2;3;4\n150;5;6;7;8\n",
        "target,run+1,ignored,ignored,ignored / 0 150 / ↑ 1 5 / columns");
    // A short row between headings and numbers.
    for (const char *units :
         {"mm;µm", "mm;µm;;;", "mm;µm\nMachine: ABC 40;Serial: 77", "Machine;ABC 40;Feed;900 mm/min\nmm;µm"})
        QTest::newRow(qPrintable(QString("below the headings: %1").arg(QString(units).simplified())))
            << "Target;Down 1;Up 1;Down 2;Up 2\n" + QByteArray(units) + "\n0;1;2;3;4\n150;5;6;7;8\n"
            << "target,run-1,run+1,run-2,run+2 / 0 150 / ↑ 2 6 / ↓ 1 5 / ↑ 4 8 / ↓ 3 7 / ";
    row("units in the place of another column",
        "No.;Target;Down 1;Up 1;Down 2;Up 2\nmm;µm\n1;0;1;2;3;4\n2;150;5;6;7;8\n",
        "ignored,target,run-1,run+1,run-2,run+2 / 0 150 / ↑ 2 6 / ↓ 1 5 / ↑ 4 8 / ↓ 3 7 / "
        "content positionUnit unit unit");
    row("headings that other words hide",
        "Target;Down 1;Up 1;Down 2;Up 2\ndoor open;by hand\n0;1;2;3;4\n150;5;6;7;8\n",
        "target,run,run,run,run / 0 150 / ↑ 1 5 / ↓ 3 7 / ↑ 2 6 / ↓ 4 8 / content directions positionUnit "
        "unit");
    // Directions as numbers: the order of the targets says which is which.
    for (const auto &[up, down] : {std::pair("1", "0"), std::pair("0", "1"), std::pair("1", "2"),
                                   std::pair("2", "1"), std::pair("1", "-1")}) {
        const QByteArray first = ';' + QByteArray(up) + ';';
        const QByteArray second = ';' + QByteArray(down) + ';';
        QTest::newRow(qPrintable(QString("codes of directions %1 and %2").arg(up, down)))
            << "Target (mm);Dir;Dev (µm)\n0" + first + "1\n70" + first + "2\n150" + first + "3\n150" +
                   second + "4\n70" + second + "5\n0" + second + "6\n0" + first + "7\n70" + first + "8\n150" +
                   first + "9\n150" + second + "10\n70" + second + "11\n0" + second + "12\n"
            << "target,direction,deviation / 0 70 150 / ↑ 1 2 3 / ↓ 6 5 4 / ↑ 7 8 9 / ↓ 12 11 10 / ";
        QTest::newRow(qPrintable(QString("codes of directions %1 and %2, numbered runs").arg(up, down)))
            << "Target (mm);Dir;Run;Dev (µm)\n0" + first + "1;1\n70" + first + "1;2\n0" + first + "2;3\n70" +
                   first + "2;4\n70" + second + "1;5\n0" + second + "1;6\n70" + second + "2;7\n0" + second +
                   "2;8\n"
            << "target,direction,number,deviation / 0 70 / ↑ 1 2 / ↓ 6 5 / ↑ 3 4 / ↓ 8 7 / ";
    }
    row("codes of directions, all ascending", "Target (mm);Dir;Dev (µm)\n0;1;1\n70;1;2\n0;0;3\n70;0;4\n",
        "target,direction,deviation / 0 70 / ↓ 1 2 / ↑ 3 4 / directions");
    row("codes of directions against the order", "Target (mm);Dir;Dev (µm)\n70;1;1\n0;1;2\n0;-1;3\n70;-1;4\n",
        "target,direction,deviation / 0 70 / ↑ 2 1 / ↓ 3 4 / directions");
    row("codes of directions that change their sense",
        "Target (mm);Dir;Run;Dev (µm)\n0;1;1;1\n70;1;1;2\n70;2;1;3\n0;2;1;4\n70;1;2;5\n0;1;2;6\n0;2;2;7\n"
        "70;2;2;8\n",
        "target,direction,number,deviation / 0 70 / ↑ 1 2 / ↓ 4 3 / ↑ 6 5 / ↓ 7 8 / directions");
    // A column of the machine, the day …: one value is a statement, several are several tests.
    const auto listOf = [](const QByteArray &heading, const QByteArray &first, const QByteArray &second) {
        return heading + ";Target (mm);Dir;Run;Dev (µm)\n" + first + ";0;+;1;1\n" + first + ";150;+;1;2\n" +
               first + ";150;-;1;3\n" + first + ";0;-;1;4\n" + second + ";0;+;2;5\n" + second +
               ";150;+;2;6\n" + second + ";150;-;2;7\n" + second + ";0;-;2;8\n";
    };
    for (const auto &[heading, first, second] :
         {std::tuple("Machine", "ABC 40", "XYZ"), std::tuple("Date", "2026-03-02", "2026-03-03"),
          std::tuple("Datum", "02.03.2026 08:10", "03.03.2026 08:10"), std::tuple("Feed", "900", "4000"),
          std::tuple("Vorschub (mm/min)", "900", "4000"), std::tuple("Opérateur", "Anne", "Luc"),
          std::tuple("Serial No.", "77", "78")}) {
        QTest::newRow(qPrintable(QString("two tests in one list: ") + heading))
            << listOf(heading, first, second)
            << "ignored,target,direction,number,deviation / 0 150 / ↑ 1 2 / ↓ 4 3 / part";
        QTest::newRow(qPrintable(QString("one test in a list: ") + heading))
            << listOf(heading, first, first)
            << "ignored,target,direction,number,deviation / 0 150 / ↑ 1 2 / ↓ 4 3 / ↑ 5 6 / ↓ 8 7 / ";
    }
    QTest::newRow("a machine in the first line of its readings")
        << listOf("Machine", "ABC 40", "XYZ").replace("\nABC 40;150", "\n;150")
        << "ignored,target,direction,number,deviation / 0 150 / ↑ 1 2 / ↓ 4 3 / part";
    for (const auto &[second, questions] : {std::pair("20.9", ""), std::pair("27.5", "columns")})
        QTest::newRow(qPrintable(QString("temperatures of lines: ") + second))
            << listOf("Temperature (°C)", "20.1", second)
            << QString("temperature,target,direction,number,deviation / 0 150 / ↑ 1 2 / ↓ 4 3 / ↑ 5 6 / "
                       "↓ 8 7 / ") +
                   questions;
    // Series over time.
    row("drift with temperature", "Time (s);Deviation (µm);Temp (°C)\n0;0;20\n60;1;20.1\n120;2;20.2\n",
        "time,deviation,temperature / channel Deviation 0:0 60:1 120:2 / temperature Temp 0:20 60:20.1 "
        "120:20.2 / ");
    row("two deviations over time", "Time (s);Dev X (µm);Dev Y (µm)\n0;0;5\n60;1;6\n",
        "time,deviation,deviation / channel X 0:0 60:1 / channel Y 0:5 60:6 / ");
    row("archive lines",
        "MILL:X 2024-03-05 10:00:00.000 0.001\nMILL:X 2024-03-05 10:01:00.000 0.002\nMILL:X 2024-03-06 "
        "10:01:00.000 0.003\n",
        "ignored,ignored,time,deviation / drift  0:1 60:2 86460:3 / kind unit");
    row("archive lines of two variables",
        "MILL:X 2024-03-05 10:00:00 0.001\nMILL:Y 2024-03-05 10:00:00 5\nMILL:X 2024-03-05 10:01:00 0.002\n",
        "ignored,ignored,time,deviation / drift  0:1 60:2 / kind series unit");
    row("archive lines after the last change of a variable at rest",
        "MILL:Y 2024-03-05 09:00:00 5\nMILL:X 2024-03-05 10:00:00 0.001\nMILL:X 2024-03-05 10:01:00 0.002\n",
        "ignored,ignored,time,deviation / drift  0:1 60:2 / kind series unit");
    // Layouts of files from the field, with numbers of our own.
    row("as found and as left above the columns",
        ";As found;;As left;\nPosition (mm);↑ (µm);↓ (µm);↑ (µm);↓ "
        "(µm)\n0;1;2;11;12\n100;3;4;13;14\n200;5;6;15;16\n",
        "target,run+,run-,ignored,ignored / 0 100 200 / ↑ 1 3 5 / ↓ 2 4 6 / state");
    row("linear and pitch above the columns",
        ";Linear (µm);;Pitch (arcsec);\nPosition "
        "(mm);Forward;Reverse;Forward;Reverse\n0;1;2;11;12\n100;3;4;13;14\n200;5;6;15;16\n",
        "target,run+,run-,ignored,ignored / 0 100 200 / ↑ 1 3 5 / ↓ 2 4 6 / columns columns");
    row("years above the columns",
        ";2024;;2025;\nPosition (mm);↑ (µm);↓ (µm);↑ (µm);↓ "
        "(µm)\n0;1;2;11;12\n100;3;4;13;14\n200;5;6;15;16\n",
        "target,run+,run-,ignored,ignored / 0 100 200 / ↑ 1 3 5 / ↓ 2 4 6 / columns columns");
    row("lines that are counted as runs", "Messung;Soll (mm);Abweichung (um)\n1;0;4\n2;100;5\n3;200;6\n",
        "ignored,target,deviation / 0 100 200 / ↑ 4 5 6 / directions");
    row("fixed width, headings of three words",
        "Position mm   Run 1 fwd   Run 1 rev\n0.000         1           2\n100.000       3           "
        "4\n200.000       5           6\n",
        "target,run+1,run-1 / 0 100 200 / ↑ 1 3 5 / ↓ 2 4 6 / content unit");
    row("fixed width, units behind the words",
        "Position mm   Error um\n0.000         1\n100.000       2\n200.000       3\n",
        "target,deviation / 0 100 200 / ↑ 1 2 3 / directions");
    row("blocks as found and as left",
        "As found\n\nTarget (mm);Actual (mm)\n0;0,001\n100;100,002\n200;200,003\n\nAs left\n\nTarget "
        "(mm);Actual (mm)\n0;0,004\n100;100,005\n200;200,006\n",
        "target,actual / 0 100 200 / ↑ 1 2 3 / directions state");
    row("volts", "Target (mm);Reading (V)\n0;1\n100;2\n200;3\n",
        "target,run / 0 100 200 / ↑ 1 2 3 / content directions unit");
    row("a unit behind a slash", "Target / mm;Deviation / um\n0;1\n100;2\n200;3\n",
        "target,deviation / 0 100 200 / ↑ 1 2 3 / directions");
    row("temperatures before deviations",
        "Time (s);Machine (°C);Air (°C)\n0;20,1;20,3\n1800;20,2;20,4\n\nTarget (mm);Forward (µm);Reverse "
        "(µm)\n0;1;2\n100;3;4\n200;5;6\n",
        "target,run+,run- / 0 100 200 / ↑ 1 3 5 / ↓ 2 4 6 / table");
    row("Czech", "Poloha (mm);Tam 1 (um);Zpět 1 (um)\n0;1;2\n100;3;4\n200;5;6\n",
        "target,run+1,run-1 / 0 100 200 / ↑ 1 3 5 / ↓ 2 4 6 / ");
    row("Russian", "Положение (мм);Вперёд 1 (мкм);Назад 1 (мкм)\n0;1;2\n100;3;4\n200;5;6\n",
        "target,run+1,run-1 / 0 100 200 / ↑ 1 3 5 / ↓ 2 4 6 / ");
    row("Chinese", "目标位置（毫米）;正向偏差1（微米）;反向偏差1（微米）\n0;1;2\n100;3;4\n200;5;6\n",
        "target,deviation+1,deviation-1 / 0 100 200 / ↑ 1 3 5 / ↓ 2 4 6 / ");
    row("Japanese", "目標位置 (mm);往路1 (ミクロン);復路1 (ミクロン)\n0;1;2\n100;3;4\n200;5;6\n",
        "target,run+1,run-1 / 0 100 200 / ↑ 1 3 5 / ↓ 2 4 6 / ");
    row("Polish",
        "Pozycja zadana (mm);Odchyłka naprzód 1 (µm);Odchyłka wstecz 1 (µm)\n0;1;2\n100;3;4\n200;5;6\n",
        "target,deviation+1,deviation-1 / 0 100 200 / ↑ 1 3 5 / ↓ 2 4 6 / ");
    row("two temperatures above",
        "Air temperature;20,1;20,3\n\nTarget (mm);Forward (µm);Reverse (µm)\n0;1;2\n100;3;4\n200;5;6\n",
        "target,run+,run- / 0 100 200 / ↑ 1 3 5 / ↓ 2 4 6 / sensor Air temperature air 20.1 / ");
    row("a table of sensors above",
        "Sensor;Start (°C);End (°C)\nSpindle;20,1;20,3\nTable;20,2;20,4\n\nTarget (mm);Forward (µm);Reverse "
        "(µm)\n0;1;2\n100;3;4\n200;5;6\n",
        "target,run+,run- / 0 100 200 / ↑ 1 3 5 / ↓ 2 4 6 / ");
    row("Pi in a list",
        "i;Pi (mm);run;direction;deviation "
        "(µm)\n1;0;1;+;1\n2;100;1;+;2\n3;200;1;+;3\n3;200;1;-;6\n2;100;1;-;5\n1;0;1;-;4\n",
        "ignored,target,number,direction,deviation / 0 100 200 / ↑ 1 2 3 / ↓ 4 5 6 / ");
    row("columns of different size", "1994,3;0,2;90,1\n1996,2;0,3;90,2\n1999,6;0,4;90,3\n",
        "target,run,run / 1994.3 1996.2 1999.6 / ↑ 0.2 0.3 0.4 / ↓ 90.1 90.2 90.3 / columns content "
        "directions positionUnit unit");
    row("a straight line in X and Y", "X (mm),Y (mm)\n0,0.1\n100,0.4\n200,0.2\n300,0.5\n400,0.1\n",
        "x,y / ISO 230-4:2005 XY R 77778 mm F – / cw polar 5: 90.153078:-122.4087 90.079412:-25.2948 "
        "90.005746:-299.6089 89.93208:54.6481 89.858414:-162.523 / kind nominalRadius");
    // What is no measurement.
    row("prose", "Dear Sir,\nthe machine is fine.\n", "refused");
    row("targets alone", "Target (mm)\n0\n100\n200\n", "refused");
}

void LayoutsTest::areReadAsPeopleReadThem() {
    QFETCH(QByteArray, text);
    QFETCH(QString, expected);
    QCOMPARE(outcome(text), expected);
}

void LayoutsTest::everyProposalCanBeKept_data() {
    areReadAsPeopleReadThem_data();
}

/// "keep" answers each question that proposes something, and changes nothing; it answers none that is owed.
void LayoutsTest::everyProposalCanBeKept() {
    QFETCH(QByteArray, text);
    Imported read;
    try {
        read = importMeasurement(text, "x.csv");
    } catch (const Error &) {
        return; // there is nothing to keep
    }
    ImportOptions answers;
    QStringList owed;
    for (const Question &question : read.questions) {
        answers[question.id] = question.id == "unread" ? std::string("leave") : std::string(keepAnswer);
        if (question.proposal.empty() && question.id != "unread")
            owed << QString::fromStdString(question.id);
    }
    const Imported kept = importMeasurement(text, "x.csv", answers);
    QVERIFY(kept.test == read.test);
    QStringList open;
    for (const Question &question : kept.questions)
        open << QString::fromStdString(question.id);
    QCOMPARE(open, owed);
}

void LayoutsTest::answersAreTaken_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("word");
    QTest::addColumn<QString>("expected");
    const QByteArray axes = "Position (mm);X ↑ (µm);X ↓ (µm);Y ↑ (µm);Y ↓ (µm)\n0;1;2;30;40\n100;3;4;50;60\n";
    QTest::newRow("the other axis") << axes << "axis"
                                    << "Y"
                                    << "target,ignored,ignored,run+,run- / 0 100 / ↑ 30 50 / ↓ 40 60 / ";
    QTest::newRow("codes the other way round")
        << QByteArray("Target (mm);Dir;Dev (µm)\n0;1;1\n70;1;2\n0;0;3\n70;0;4\n") << "directions"
        << "reversed"
        << "target,direction,deviation / 0 70 / ↑ 1 2 / ↓ 3 4 / ";
    QTest::newRow("headings the other way round")
        << QByteArray("Target (mm);pos 1 (µm);neg 1 (µm)\n0;1;5\n100;3;7\n") << "directions"
        << "reversed"
        << "target,run+1,run-1 / 0 100 / ↑ 5 7 / ↓ 1 3 / ";
    const QByteArray machines = "Machine;Target (mm);Dir;Dev (µm)\nA 1;0;+;1\nA 1;90;+;2\nB 2;0;+;3\n"
                                "B 2;90;+;4\n";
    QTest::newRow("the other machine") << machines << "part"
                                       << "B 2"
                                       << "ignored,target,direction,deviation / 0 90 / ↑ 3 4 / ";
    QTest::newRow("both machines") << machines << "columns"
                                   << "ignored,target,direction,deviation"
                                   << "ignored,target,direction,deviation / 0 90 / ↑ 1 2 / ↑ 3 4 / ";
    QTest::newRow("a machine that is not there") << machines << "part"
                                                 << "C 3"
                                                 << "refused";
    QTest::newRow("the angles count clockwise")
        << QByteArray("Direction: CW\nRadius: 80 mm\nAngle (°);Deviation (µm)\n0;1\n90;2\n180;1\n270;0\n")
        << "sense"
        << "mirrored"
        << "angle,deviation / ISO 230-4:2005 XY R 80 mm F – / cw polar 4: 0:1 -90:2 -180:1 -270:0 / ";
    QTest::newRow("the sense of the angles")
        << QByteArray("Direction: CW\nRadius: 80 mm\nAngle (°);Deviation (µm)\n0;1\n90;2\n180;1\n270;0\n")
        << "sense"
        << "angles"
        << "angle,deviation / ISO 230-4:2005 XY R 80 mm F – / ccw polar 4: 0:1 90:2 180:1 270:0 / ";
    const QByteArray days = "Date: 2026-03-14\nForward\nP (mm);Run 1 (µm)\n0;1\n100;3\n\n"
                            "Date: 2026-06-14\nBackward\nP (mm);Run 1 (µm)\n0;5\n100;7\n";
    QTest::newRow("the other day") << days << "part"
                                   << "2026-06-14"
                                   << "target,run1 / 0 100 / ↓ 5 7 / ";
    QTest::newRow("both days") << days << "part"
                               << "2026-03-14; 2026-06-14"
                               << "target,run1 / 0 100 / ↑ 1 3 / ↓ 5 7 / ";
    QTest::newRow("columns") << axes << "columns"
                             << "target,ignored,ignored,ignored,run-"
                             << "target,ignored,ignored,ignored,run- / 0 100 / ↓ 40 60 / ";
    QTest::newRow("too many columns") << axes << "columns"
                                      << "target,run,run,run,run,run"
                                      << "refused";
    QTest::newRow("columns of different roles") << axes << "columns"
                                                << "target,run,deviation"
                                                << "refused";
    QTest::newRow("columns of dates")
        << QByteArray("Target (mm);Forward (µm);Reverse (µm)\n0;1;2\n100;2026-01-05;3\n200;01:30;4\n")
        << "columns"
        << "target,run+,run-"
        << "target,run+,run- / 0 100 200 / ↑ 1 – – / ↓ 2 3 4 / unread";
    QTest::newRow("one column of dates")
        << QByteArray("Target (mm);Forward (µm)\n0;1\n100;2026-01-05\n200;01:30\n") << "columns"
        << "target,run+"
        << "target,run+ / 0 100 200 / ↑ 1 – – / layout unread";
    QTest::newRow("data left out") << QByteArray("P (mm);1↑ (µm);1↓ (µm)\n0;1;2\n100;3,,5;4\n") << "unread"
                                   << "leave"
                                   << "target,run+1,run-1 / 0 100 / ↑ 1 – / ↓ 2 4 / ";
    QTest::newRow("large deviations")
        << QByteArray("P (mm);Dev ↑ (mm);Dev ↓ (mm)\n0;1.5;2.5\n100;3.5;4.5\n") << "large"
        << "keep"
        << "target,deviation+,deviation- / 0 100 / ↑ 1500 3500 / ↓ 2500 4500 / ";
    QTest::newRow("the other variable")
        << QByteArray(
               "A 2024-03-05 10:00:00 1\nB 2024-03-05 10:00:00 5\nA 2024-03-05 10:01:00 2\nB 2024-03-05 "
               "10:01:00 6\n")
        << "series"
        << "B"
        << "ignored,ignored,time,deviation / drift  0:5 60:6 / kind unit";
}

void LayoutsTest::answersAreTaken() {
    QFETCH(QByteArray, text);
    QFETCH(QString, key);
    QFETCH(QString, word);
    QFETCH(QString, expected);
    QCOMPARE(outcome(text, {{key.toStdString(), word.toStdString()}}), expected);
}

/// Readings of the other sign than their heading has are not taken without a word.
void LayoutsTest::aSignProvenByPositionsIsSaid() {
    for (const bool isOpposite : {false, true}) {
        const QByteArray sign = isOpposite ? "-" : "";
        const Imported imported =
            importMeasurement("Soll (mm);Ist (mm);Abweichung (µm)\n0;0.0015;" + sign + "1.5\n100;100.0025;" +
                                  sign + "2.5\n200;200.0035;" + sign + "3.5\n",
                              "x.csv", {});
        const auto &measurement = std::get<PositioningMeasurement>(imported.test->measurement);
        QVERIFY(std::abs(*measurement.runs.at(0).deviations.at(2) - 0.0035) < 1e-12);
        QCOMPARE(testdata::remarks(imported).contains("target − actual"), isOpposite);
    }
}

/// Words of a heading of blanks may stray to the column before.
void LayoutsTest::aDirectionAboveTheTargetsIsDoubted() {
    const QByteArray below = "Target             Run 1\n[mm]                [mm]\n-600.5            0.0250\n"
                             "-349.5            0.0337\n336.5             0.0147\n";
    const auto isDoubted = [](const QByteArray &table) {
        const Imported imported = importMeasurement(table, "x.csv");
        return std::ranges::any_of(imported.questions, [](const Question &question) {
            return question.id == "directions" && question.grade == QuestionGrade::doubtful;
        });
    };
    QVERIFY(!isDoubted(below));
    QVERIFY(isDoubted("             back deviation\n" + below));
}

void LayoutsTest::anotherOrderOfDirectionsIsSaid() {
    for (const bool isDownFirst : {false, true}) {
        const QByteArray first = isDownFirst ? "Down" : "Up";
        const QByteArray second = isDownFirst ? "Up" : "Down";
        const Imported imported =
            importMeasurement("Target (mm);" + first + " 1 (µm);" + second + " 1 (µm);" + first + " 2 (µm);" +
                                  second + " 2 (µm)\n0;1;2;3;4\n100;5;6;7;8\n200;1;2;3;4\n",
                              "x.csv", {});
        const auto &measurement = std::get<PositioningMeasurement>(imported.test->measurement);
        QCOMPARE(measurement.runs.at(0).approach, Direction::positive);
        QCOMPARE(*measurement.runs.at(0).deviations.at(0), isDownFirst ? 0.002 : 0.001);
        QCOMPARE(testdata::remarks(imported).contains("is put first"), isDownFirst);
    }
}

void LayoutsTest::anOrderThatIsNotStatedIsInTurn_data() {
    QTest::addColumn<QByteArray>("heads");
    QTest::addColumn<QString>("order");
    QTest::addColumn<bool>("remarked");
    QTest::newRow("in turn") << QByteArray("↑1 (µm),↓1 (µm),↑2 (µm),↓2 (µm)") << "↑↓↑↓" << false;
    QTest::newRow("all up, all down") << QByteArray("↑ (µm),↑ (µm),↓ (µm),↓ (µm)") << "↑↓↑↓" << true;
    QTest::newRow("numbered each way") << QByteArray("↑1 (µm),↑2 (µm),↓1 (µm),↓2 (µm)") << "↑↓↑↓" << true;
    QTest::newRow("numbered through") << QByteArray("↑1 (µm),↑2 (µm),↓3 (µm),↓4 (µm)") << "↑↑↓↓" << false;
    QTest::newRow("one way") << QByteArray("↑1 (µm),↑2 (µm),↑3 (µm),↑4 (µm)") << "↑↑↑↑" << false;
}

/// Nobody knows the cycle of a table.
void LayoutsTest::anOrderThatIsNotStatedIsInTurn() {
    QFETCH(QByteArray, heads);
    QFETCH(QString, order);
    QFETCH(bool, remarked);
    const Imported imported =
        importMeasurement("P (mm)," + heads + "\n0,1,2,3,4\n100,2,1,4,3\n200,1,1,2,2\n", "x.csv", {});
    const auto &measurement = std::get<PositioningMeasurement>(imported.test->measurement);
    QString runs;
    for (const Run &run : measurement.runs)
        runs += run.approach == Direction::positive ? "↑" : "↓";
    QCOMPARE(runs, order);
    QVERIFY(!measurement.cycle);
    QCOMPARE(testdata::remarks(imported).contains("Order of the runs"), remarked);
}

/// Readings that are not read are all named, in a question.
/// The squares of positions near a kilometre keep no digits for half a micrometre of scatter.
void LayoutsTest::directionsOfFarPositionsAreGuessedAsOfNearOnes() {
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0, 0.0005);
    for (int round = 0; round < 10; ++round) {
        QByteArray text = "P (mm);1;2;3;4;5;6\n";
        for (const double target : {900000.0, 900100.0, 900210.0, 900290.0, 900400.0}) {
            text += QByteArray::number(target, 'f', 0);
            for (int run = 0; run < 6; ++run)
                text += ';' + QByteArray::number(target + (run < 3 ? 0 : 0.008) + noise(random), 'f', 4);
            text += '\n';
        }
        const Imported imported = importMeasurement(text, "x.csv", {});
        const auto question = std::ranges::find(imported.questions, "directions", &Question::id);
        QVERIFY(question != imported.questions.end());
        QCOMPARE(QString::fromStdString(question->proposal), QString("sideBySide"));
    }
}

/// Runs in another order than that of their numbers, ↑ before ↓ of each.
void LayoutsTest::anOrderOfRunsIsNoOrderOfDirections() {
    const QString remarks = testdata::remarks(importMeasurement(
        "P (mm);Run 3 up (µm);Run 3 down (µm);Run 1 up (µm);Run 1 down (µm)\n0;1;2;3;4\n100;5;6;7;8\n",
        "x.csv"));
    QVERIFY2(remarks.contains("that of their numbers") && !remarks.contains("↓ comes before ↑"),
             qPrintable(remarks));
}

void LayoutsTest::namesAllColumnsLeftOut() {
    const Imported imported =
        importMeasurement("Target (mm);Forward (µm);;;Reverse (µm);\n0;1;2;3;4;5\n100;2;3;4;5;6\n", "x.csv");
    QVERIFY(std::ranges::any_of(imported.questions, [](const Question &question) {
        return question.id == "columns" &&
               Language(Language::Id::english).sentence(question.sentence).endsWith(": #3, #4, #6.");
    }));
}

QTEST_GUILESS_MAIN(LayoutsTest)
#include "layouts.moc"
