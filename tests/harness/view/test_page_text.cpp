#include "view/page_text.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace
{

using namespace twiddle;

// Expected: the five characters that HTML knows as its own.
TEST(PageText, html_escapes_what_could_be_markup)
{
    EXPECT_EQ(view::html_text("a<b>&\"c'"), "a&lt;b&gt;&amp;&quot;c&#39;");
}

// Expected: percent signs of RFC 3986, and never a scheme: a link begins with ./
TEST(PageText, link_is_relative_and_escaped)
{
    EXPECT_EQ(view::link_text("a/b-c_1.html"), "./a/b-c_1.html");
    EXPECT_EQ(view::link_text("javascript:x\" y"), "./javascript%3Ax%22%20y");
}

// Expected: nothing that ends a script or a line, and the same value after reading.
TEST(PageText, json_in_a_script_reads_back_and_ends_nothing)
{
    const record::Json value = {{"text", "</script><!--\u2028\u2029\"\\"}};
    const std::string text = view::script_json(value);
    for (const char *part : {"<", "\u2028", "\u2029"}) {
        EXPECT_EQ(text.find(part), std::string::npos) << text;
    }
    EXPECT_EQ(record::Json::parse(text), value);
}

// A command line may hold any bytes; expected: valid JSON all the same.
TEST(PageText, bytes_that_are_no_utf8_are_replaced)
{
    EXPECT_NO_THROW(record::Json::parse(view::script_json({{"text", "\xff\xfe"}})));
}

// What is filled in is not looked through for names, nor is a sign that is no name lost.
TEST(PageText, page_is_filled_once)
{
    EXPECT_EQ(view::filled_page("@A@ at@home @B@@A@", {{"A", "@B@"}, {"B", "b"}}), "@B@ at@home b@B@");
}

} // namespace
