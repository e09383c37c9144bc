// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/workeranswers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace palmer {

namespace {

WorkerAnswer answerOf(const QByteArray &bytes) {
    std::array<char, sizeof(WorkerAnswer)> head{};
    std::ranges::copy(bytes.first(sizeof(WorkerAnswer)), head.begin());
    return std::bit_cast<WorkerAnswer>(head);
}

} // namespace

QByteArray bytesOf(const WorkerAnswer &answer) {
    const auto bytes = std::bit_cast<std::array<char, sizeof(WorkerAnswer)>>(answer);
    return {bytes.data(), sizeof(WorkerAnswer)};
}

QByteArray bytesOf(int input, const FinishedJob &job) {
    return bytesOf({input, job.result.code, job.printed.size(), job.errors.size(), job.result.rows.size()}) +
           job.printed + job.errors + job.result.rows;
}

void takeAnswers(QByteArray &bytes, std::optional<int> &input, FinishedJobs &ended) {
    while (bytes.size() >= qsizetype(sizeof(WorkerAnswer))) {
        const WorkerAnswer answer = answerOf(bytes);
        input = answer.input;
        qsizetype at = sizeof answer;
        if (answer.code != WorkerAnswer::atWork) {
            if (bytes.size() < at + answer.printed + answer.errors + answer.rows)
                return;
            FinishedJob done;
            done.printed = bytes.mid(at, answer.printed);
            done.errors = bytes.mid(at += answer.printed, answer.errors);
            done.result = {answer.code, bytes.mid(at += answer.errors, answer.rows)};
            at += answer.rows;
            ended.emplace(answer.input, std::move(done));
            input.reset();
        }
        bytes.remove(0, at);
    }
}

} // namespace palmer
