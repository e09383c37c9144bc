#pragma once

#include "kernel/words/message.h"

#include <string>

namespace palmer {

/// requirement: the standard says "shall"; recommendation: "should" (fr. « il convient »); note: worth
/// knowing.
enum class Grade { requirement, recommendation, note };

/// Something the edition asks for and this test does not have, or what a reader of the results must know.
/// `id`: stable, for scripts; of a missing statement the key in the file. `clause`: empty where it is not
/// known.
struct Finding {
    Grade grade = Grade::note;
    std::string id;
    std::string clause;
    Message message;

    bool operator==(const Finding &) const = default;
};

} // namespace palmer
