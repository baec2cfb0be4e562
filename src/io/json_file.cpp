#include "io/json_file.h"

#include "io/io_error.h"
#include "io/whole_file.h"

namespace tank_datum {

nlohmann::json readJson(const std::string& path, const std::string& stage, const std::string& expected) {
  const auto refused = [&](const std::string& value, const std::string& wanted) {
    return Error(Error::Kind::File, stage, {echoPath(path), value, wanted, path});
  };
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(wholeFile(path, stage));
  } catch (const Error& error) {
    throw reworded(error, stage, echoPath(path), path, expected);
  } catch (const nlohmann::json::parse_error& error) {
    throw refused("no JSON at byte " + std::to_string(error.byte), expected);
  } catch (const nlohmann::json::exception&) {
    throw refused("a number beyond 64 bits", expected);
  }
  if (!json.is_object()) throw refused("no JSON object", expected);
  const auto schema = json.find("schema");
  if (schema == json.end() || !schema->is_number_integer()) throw refused("without a schema", expected);
  const bool newer = *schema > kSchema;
  if (newer || *schema < kFirstSchema) {
    throw refused("schema " + schema->dump(), "schema " + std::to_string(kSchema) + " or older" +
                                                  (newer ? ": a newer version wrote it" : ", from 1 on"));
  }
  return json;
}

}  // namespace tank_datum
