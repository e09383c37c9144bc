#include "document/writedocument.h"

#include "document/fields.h"
#include "document/fileversion.h"
#include "document/filewords.h"
#include "document/json.h"
#include "document/refusedreadings.h"

#include <nlohmann/json.hpp>

namespace palmer {

namespace {

using nlohmann::json;

// Puts the fields of a struct into an object; the functions for values are members, for they call each other.
class ObjectWriter {
public:
    /// `newFields` becomes true once a field of version 2 is written.
    ObjectWriter(json &object, bool &newFields)
        : m_object(object)
        , m_newFields(newFields) {}

    template <class T>
    void operator()(const char *key, const T &member, unsigned demands = nothing) {
        if ((demands & added) != 0) {
            if (member == T{})
                return;
            m_newFields = true;
        }
        m_object[key] = toJson(member);
    }

    void object(const char *key, const auto &members) {
        json &inner = m_object[key] = json::object();
        ObjectWriter writer(inner, m_newFields);
        members(writer);
    }

    void extensions(const char *key, const std::string &text) { m_object[key] = parseJson(text); }

    template <class Struct>
    requires std::is_class_v<Struct> json toJson(const Struct &value) {
        json object = json::object();
        ObjectWriter writer(object, m_newFields);
        fields(writer, value);
        return object;
    }

private:
    template <class Scalar>
    requires std::is_arithmetic_v<Scalar> json toJson(Scalar value) { return value; }

    template <class Enumeration>
    requires std::is_enum_v<Enumeration> json toJson(Enumeration value) { return fileWord(value); }

    json toJson(const std::string &value) { return value; }

    json toJson(const TestPointer &test) {
        json object = toJson(*test);
        object["kind"] = fileWord(kindOf(*test));
        addRefusedReadings(*test, object["extensions"]);
        return object;
    }

    template <class T>
    json toJson(const std::optional<T> &value) {
        return value ? toJson(*value) : json();
    }

    template <class T>
    json toJson(const std::vector<T> &values) {
        return list(values);
    }

    json toJson(const Point3 &values) { return list(values); }

    template <class T>
    json toJson(const std::map<std::string, T> &values) {
        json object = json::object();
        for (const auto &[key, value] : values)
            object[key] = toJson(value);
        return object;
    }

    json list(const auto &values) {
        json::array_t array;
        array.reserve(values.size());
        for (const auto &value : values)
            array.push_back(toJson(value));
        return array;
    }

    json &m_object;
    bool &m_newFields;
};

} // namespace

QByteArray writeDocument(const Document &document) {
    bool newFields = false;
    json none;
    json file = ObjectWriter(none, newFields).toJson(document);
    file["format"] = fileFormat;
    file["version"] = newFields ? fileVersion : firstVersion; // older programs read what they can
    return QByteArray::fromStdString(printJson(file));
}

} // namespace palmer
