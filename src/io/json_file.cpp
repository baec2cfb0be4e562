#include "io/json_file.h"

#include "io/io_error.h"
#include "io/whole_file.h"

namespace tank_datum {

nlohmann::json readJson(const std::string& path, const std::string& stage, const std::string& expected) {
  const auto refused = [&](const std::string& value, const std::string& wanted) {
    return Error(Error::Kind::File, stage, echoPath(path), value, wanted);
  };
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(wholeFile(path, stage));
  } catch (const Error& error) {
    throw refused(error.refused().value, expected);
  } catch (const nlohmann::json::exception& error) {
    throw refused(error.what(), expected);
  }
  if (!json.is_object()) throw refused("no JSON object", expected);
  const auto schema = json.find("schema");
  if (schema == json.end() || !schema->is_number_integer()) throw refused("without a schema", expected);
  if (*schema > kSchema) {
    throw refused("schema " + schema->dump(),
                  "schema " + std::to_string(kSchema) + " or older: a newer version wrote it");
  }
  return json;
}

}  // namespace tank_datum
