#include "target.hpp"

#include "choices.hpp"
#include "engine/engine.hpp"
#include "link/chip_agent.hpp"
#include "link/emulator.hpp"
#include "link/serial_port.hpp"
#include "own_program.hpp"
#include "runs/usage_error.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace twiddle::cli
{

namespace
{

const std::string host = "host";
const std::string at_port = "port";
const std::string chip_number = "fixed";

unsigned baud_of(const std::string &text)
{
    const std::vector<unsigned> speeds = link::serial_speeds();
    const auto speed = whole_number("--baud", text, speeds.front(), speeds.back());
    if (std::find(speeds.begin(), speeds.end(), speed) != speeds.end()) return static_cast<unsigned>(speed);
    std::vector<std::string> names;
    for (const unsigned known : speeds) {
        names.push_back(std::to_string(known));
    }
    throw runs::UsageError("--baud " + text + ": expected one of " + comma_list(names));
}

// The image that `make firmware` builds beside this program's own build.
std::filesystem::path firmware_image(const std::string &board)
{
    const std::filesystem::path builds = own_folder().parent_path().parent_path();
    const std::filesystem::path image = builds / "firmware" / (board + "-O2") / "bin" / "agent_fixed";
    if (!std::filesystem::exists(image))
        throw std::runtime_error("there is no firmware '" + image.string() + "'; make firmware builds it");
    return image;
}

std::unique_ptr<link::Connection> connect(const Target &target)
{
    if (target.name == at_port) return std::make_unique<link::SerialPort>(target.port, target.baud);
    return std::make_unique<link::Emulator>(target.name, firmware_image(target.name));
}

} // namespace

Target target_of(const RunOptions &run, const PortOptions &port)
{
    Target target;
    target.name = port.port.empty() ? run.target : at_port;
    target.port = port.port;
    target.baud = baud_of(port.baud);
    target.number = run.number;
    if (target.name == host) return target;
    if (run.number_given && run.number != chip_number)
        throw runs::UsageError("chips compute in fixed point; leave out --number " + run.number);
    target.number = chip_number;
    return target;
}

engine::AgentMaker agent_maker(const Target &target)
{
    if (target.name == host) return engine::engine_of_number(target.number).make_agent;
    return [target](const engine::AgentSetup &setup) { return link::make_chip_agent(connect(target), setup); };
}

} // namespace twiddle::cli
