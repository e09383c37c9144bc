#include "commands/outputfile.h"

#include "commands/streams.h"
#include "document/savedocument.h"

namespace palmer {

void writeOutput(const QByteArray &bytes, const QString &file) {
    if (file == QLatin1StringView("-"))
        printOut(bytes);
    else
        saveBytes(bytes, file);
}

} // namespace palmer
