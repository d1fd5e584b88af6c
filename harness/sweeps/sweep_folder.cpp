#include "sweep_folder.hpp"

#include "record/json_file.hpp"
#include "runs/usage_error.hpp"

#include <random>
#include <string>
#include <system_error>

namespace twiddle::sweeps
{

namespace
{

namespace fs = std::filesystem;

const std::string file_name = "sweep.json";
const std::string advice = "; choose another folder by --out";

// Whether there is something in the folder that no start of a sweep leaves.
bool holds_something_else(const fs::path &folder)
{
    for (const fs::directory_entry &entry : fs::directory_iterator(folder)) {
        if (entry.path().filename().string().rfind(file_name, 0) != 0) return true;
    }
    return false;
}

// A name that no other process takes, on whatever machine.
fs::path name_of_our_own(const fs::path &path)
{
    std::random_device random;
    fs::path own = path;
    own += "." + std::to_string(random()) + "-" + std::to_string(random());
    return own;
}

// Write the file under a name of our own, then give it its name unless another process was first.
void create(const fs::path &path, const record::Json &sweep)
{
    const fs::path own = name_of_our_own(path);
    record::write_json(own, sweep);
    std::error_code error;
    fs::create_hard_link(own, path, error);
    if (error && error != std::errc::file_exists) { // a file system without links
        fs::rename(own, path);
        return;
    }
    fs::remove(own);
}

std::string difference(const record::Json &found, const record::Json &wanted, const std::string &key)
{
    const record::Json value = found.value(key, record::Json());
    if (!wanted[key].is_structured()) return key + " is " + value.dump() + " there and " + wanted[key].dump() + " here";
    return "its " + key + " are others";
}

void require_same(const fs::path &path, const record::Json &sweep)
{
    record::Json found;
    try {
        found = record::read_json(path);
    } catch (const std::runtime_error &error) {
        throw runs::UsageError(error.what() + advice);
    }
    if (found == sweep) return;
    for (const auto &[key, value] : sweep.items()) {
        if (found.value(key, record::Json()) != value)
            throw runs::UsageError("'" + path.string() + "' is of another sweep: " + difference(found, sweep, key) +
                                   advice);
    }
    throw runs::UsageError("'" + path.string() + "' is of another sweep" + advice);
}

} // namespace

void make_folder(const fs::path &folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw std::runtime_error("cannot make folder '" + folder.string() + "': " + error.message());
}

void claim_sweep(const fs::path &folder, const SweepPlan &plan)
{
    const record::Json sweep = sweep_json(plan);
    const fs::path path = folder / file_name;
    if (fs::exists(folder) && !fs::is_directory(folder))
        throw runs::UsageError("'" + folder.string() + "' is no folder" + advice);
    make_folder(folder);
    // In this order: another process that has just begun writes sweep.json before its first run.
    if (holds_something_else(folder) && !fs::exists(path))
        throw runs::UsageError("'" + folder.string() + "' holds files that are no sweep of twiddle" + advice);
    if (!fs::exists(path)) create(path, sweep);
    require_same(path, sweep);
}

} // namespace twiddle::sweeps
