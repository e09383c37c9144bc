// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/phrasetext.h"

namespace palmer {

RichText richText(const Phrase &phrase, bool bold) {
    RichText result;
    for (const Span &span : phrase.spans) {
        TextRun run;
        run.text = span.text;
        run.bold = (bold || span.bold) && !span.muted;
        run.italic = span.italic;
        run.script = span.subscript ? TextRun::Script::subscript : TextRun::Script::normal;
        run.grey = span.muted;
        result.push_back(run);
    }
    return result;
}

} // namespace palmer
