// Links every object of palmer_core with Qt Core alone: a widget in core would not link.
#include <QtGlobal>

int main() {
    return qVersion() != nullptr ? 0 : 1;
}
