// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/pastedtable.h"

#include "import/importmeasurement.h"

#include <QByteArray>
#include <algorithm>
#include <array>
#include <iterator>

namespace palmer {

ImportOptions usualUnits(Motion motion, const DisplayUnits &units) {
    const auto both = [](const char *reading, const char *position) {
        return ImportOptions{{"unit", reading}, {"positionUnit", position}, {"timeUnit", "s"}};
    };
    if (motion == Motion::rotary)
        return both(units.angles == AngleDisplay::degrees ? "deg" : "arcsec", "deg");
    switch (units.lengths) {
    case LengthDisplay::millimetres:
        return both("mm", "mm");
    case LengthDisplay::inches:
        return both("uin", "in");
    case LengthDisplay::micrometres:
        break;
    }
    return both("um", "mm");
}

Imported readPastedTable(const std::string &text, ImportOptions known, const ImportOptions &usual) {
    known.insert({"format", "table"});
    Imported imported = importMeasurement(QByteArray::fromStdString(text), {}, known, usual);
    const auto isOfTest = [](std::string_view choice) {
        constexpr std::array<std::string_view, 5> ofTest{"calibrated", "correctionTo20", "plane", "axis",
                                                         "motion"};
        return std::ranges::find(ofTest, choice) != ofTest.end();
    };
    std::erase_if(imported.questions,
                  [&](const Question &question) { return isOfTest(question.id) && question.canBeAssumed(); });
    std::erase_if(imported.remarks,
                  [&](const Remark &remark) { return isOfTest(remark.choice) || remark.choice == "sign"; });
    return imported;
}

std::vector<Message> remarksOfPaste(const Imported &imported) {
    std::vector<Message> remarks;
    for (const Remark &remark : imported.remarks) {
        if (remark.grade != RemarkGrade::note)
            remarks.push_back(remark.message);
    }
    for (const Question &question : imported.questions) {
        if (question.canBeAssumed())
            remarks.push_back(question.sentence);
    }
    return remarks;
}

std::vector<Question> doubtsOf(const Imported &imported) {
    std::vector<Question> doubts;
    std::ranges::copy_if(imported.questions, std::back_inserter(doubts),
                         [](const Question &question) { return !question.canBeAssumed(); });
    return doubts;
}

} // namespace palmer
