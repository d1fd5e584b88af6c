// main.cpp: the twiddle program: reads the command line, runs one command, and says what went wrong in one sentence.

#include "commands.hpp"
#include "errors.hpp"
#include "record/versions.hpp"
#include "sim/world.hpp"

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <string>

namespace
{

using namespace twiddle::cli;

int complain(std::string sentence, int status)
{
    std::replace(sentence.begin(), sentence.end(), '\n', ' ');
    std::cout << std::flush;
    std::cerr << "twiddle: " << sentence << '\n';
    return status;
}

int run(int argc, char **argv)
{
    Session session;
    session.arguments.assign(argv, argv + argc);
    CLI::App app("Rhythmic hand skills, learned by trial and error.", "twiddle");
    app.set_version_flag("--version", twiddle::record::version_line());
    add_train(app, session);
    add_sweep(app, session);
    add_calibrate(app, session);
    add_replay(app, session);
    add_rollout(app, session);
    add_export(app, session);
    add_summarize(app, session);
    add_compare_claims(app, session);
    add_info(app, session);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success &asked) { // --help and --version
        return app.exit(asked);
    } catch (const CLI::ParseError &error) {
        return complain(std::string(error.what()) + "; see --help", exit_wrong_use);
    }
    if (!session.run)
        throw UsageError("a command is missing: train, sweep, calibrate, replay, rollout, export, summarize, "
                         "compare-claims or info; see --help");
    const int status = session.run();
    if (!(std::cout << std::flush)) throw std::runtime_error("cannot write to standard output");
    return status;
}

} // namespace

int main(int argc, char **argv)
{
    try {
        return run(argc, argv);
    } catch (const twiddle::sim::NotCovered &error) {
        return complain(error.what(), exit_wrong_use);
    } catch (const UsageError &error) {
        return complain(error.what(), exit_wrong_use);
    } catch (const std::exception &error) {
        return complain(error.what(), exit_failure);
    }
}
