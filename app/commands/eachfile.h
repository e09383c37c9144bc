#pragma once

#include "commands/command.h"
#include "commands/streams.h"

namespace palmer {

/// Works on every file of the invocation, also after a bad one, whose error is one line. `work` takes the
/// name and the document and returns an exit code; the worst is returned.
template <typename Work>
int eachFile(const Invocation &invocation, Work work) {
    int code = done;
    for (const QString &file : invocation.arguments) {
        std::optional<Document> document;
        try {
            document = documentFrom(file, invocation);
        } catch (const Error &error) {
            printError(file, error, invocation.language);
            code = worse(code, cannotRead);
            continue;
        }
        if (!document) { // questions about it are open
            code = worse(code, cannotRead);
            continue;
        }
        code = worse(code, work(file, std::move(*document)));
    }
    return code;
}

} // namespace palmer
