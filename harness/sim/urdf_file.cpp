#include "urdf_file.hpp"

#include "settings/text_file.hpp"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

namespace twiddle::sim
{
namespace
{

// Takes what urdfdom would print, for as long as it lives, and keeps its first error.
class FirstError : public console_bridge::OutputHandler
{
  public:
    FirstError() : before_(console_bridge::getOutputHandler())
    {
        console_bridge::useOutputHandler(this);
    }
    ~FirstError() override
    {
        console_bridge::useOutputHandler(before_);
    }
    FirstError(const FirstError &) = delete;
    FirstError &operator=(const FirstError &) = delete;

    void log(const std::string &text, console_bridge::LogLevel level, const char *, int) override
    {
        if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && text_.empty()) text_ = text;
    }

    // Its first sentence, on one line, without a full stop; empty if there was no error.
    std::string text() const
    {
        std::string line = text_;
        std::replace(line.begin(), line.end(), '\n', ' ');
        line.erase(std::min(line.find(". "), line.size()));
        line.erase(line.find_last_not_of(" .") + 1);
        return line;
    }

  private:
    console_bridge::OutputHandler *before_;
    std::string text_;
};

// The number of links from `link` on; ends where no link hangs on two joints.
std::size_t count_links(const urdf::Link &link)
{
    std::size_t count = 1;
    for (const auto &child : link.child_links)
        count += count_links(*child);
    return count;
}

// One root and as many joints as other links: each hangs on one joint, so that what cannot be reached is a ring.
bool is_tree(const urdf::ModelInterface &model)
{
    return model.joints_.size() + 1 == model.links_.size() && count_links(*model.getRoot()) == model.links_.size();
}

} // namespace

urdf::ModelInterfaceSharedPtr read_urdf(const std::filesystem::path &path)
{
    const std::string text = settings::read_text_file(path);
    FirstError error;
    urdf::ModelInterfaceSharedPtr model;
    try {
        model = urdf::parseURDF(text);
    } catch (const std::exception &exception) {
        throw std::runtime_error(path.string() + ": this is no valid URDF: " + exception.what());
    }
    if (!error.text().empty()) throw std::runtime_error(path.string() + ": this is no valid URDF: " + error.text());
    if (!model || !model->getRoot()) throw std::runtime_error(path.string() + ": this is no valid URDF: no root link");
    if (!is_tree(*model)) {
        for (auto &link : model->links_)
            link.second->child_links.clear(); // a ring of links would own itself for ever
        throw std::runtime_error(path.string() + ": the links are no tree; each must hang on one joint");
    }
    return model;
}

} // namespace twiddle::sim
