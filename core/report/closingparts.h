#pragma once

#include "report/composereport.h"
#include "report/testpart.h"

namespace palmer {

/// The instruments of all tests with what makes them traceable.
void addTraceability(std::vector<Block> &blocks, const Writer &write, const EvaluatedDocument &evaluated);

/// The drift tests of the file with their range.
void addDriftTests(std::vector<Block> &blocks, const Writer &write, const EvaluatedDocument &evaluated);

/// What ISO/IEC 17025, 7.8 asks a report to state, the program and the fingerprint in full.
void addStatements(std::vector<Block> &blocks, const Writer &write, const Document &document,
                   const ReportOptions &options, const QString &fingerprint);

/// Those who sign, and the end of the report.
void addSignatures(std::vector<Block> &blocks, const Writer &write, const ReportHead &head);

} // namespace palmer
