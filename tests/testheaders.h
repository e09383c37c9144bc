#pragma once
// Precompiled for all tests.
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <string>
#include <variant>
#include <vector>
