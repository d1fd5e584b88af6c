// manifest_file.hpp: a TOML file that a user wrote, read value by value, with one sentence about whatever is wrong with
// it: "FILE:LINE: what". All functions but has() throw it as std::runtime_error.
#pragma once

#include "toml_file.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace twiddle::settings
{

using Pointer = nlohmann::json::json_pointer; // where a value stands, e.g. "/runs/0/seeds"
using Names = std::vector<std::string>;

bool contains(const Names &names, const std::string &name);

class ManifestFile
{
  public:
    explicit ManifestFile(const std::filesystem::path &path);

    // Complain of `place`; its line, or that of what is around it, is named.
    [[noreturn]] void fail(Pointer place, const std::string &what) const;

    // Complain of the value at `place`, or that there is none.
    [[noreturn]] void fail_value(const Pointer &place, const std::string &expected) const;

    bool has(const Pointer &place) const;

    const nlohmann::json &at(const Pointer &place, const std::string &expected) const;

    // Refuse keys at `place` that are not `known`.
    void require_keys(const Pointer &place, const Names &known) const;

    // From 1 to `upper`.
    std::int64_t whole_number(const Pointer &place, std::int64_t upper) const;

    // Two finite numbers, the first below the second.
    std::pair<double, double> range(const Pointer &place) const;

    // One of `known`; `silent` where the manifest says nothing.
    std::string name(const Pointer &place, const Names &known, const std::string &silent) const;

    // "all", or a list of some of `known`.
    Names names(const Pointer &place, const Names &known) const;

    // A list of truth values; {true} where the manifest says nothing.
    std::vector<bool> flags(const Pointer &place) const;

    // How many tables [[KEY]] stand at `place`, at least one.
    std::size_t blocks(const Pointer &place) const;

  private:
    std::filesystem::path path_;
    TomlFile file_;
};

} // namespace twiddle::settings
