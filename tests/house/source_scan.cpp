#include "source_scan.h"

#include <algorithm>
#include <cctype>

namespace house {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// Position after the literal that starts at i with the quote text[i]; digit separators are no literals.
std::size_t end_of_literal(const std::string& text, std::size_t i) {
  const char quote = text[i];
  if (quote == '"' && i > 0 && text[i - 1] == 'R') {
    const std::string close = ")" + text.substr(i + 1, text.find('(', i) - i - 1) + "\"";
    return std::min(text.size(), text.find(close, i) + close.size());
  }
  if (quote == '\'' && i > 0 && is_word(text[i - 1])) return i + 1;
  for (++i; i < text.size() && text[i] != quote; ++i) {
    if (text[i] == '\\') ++i;
  }
  return std::min(text.size(), i + 1);
}

std::size_t end_of_directive(const std::string& text, std::size_t i) {
  while (i < text.size() && !(text[i] == '\n' && text[i - 1] != '\\')) ++i;
  return i;
}

bool starts_line(const std::string& text, std::size_t i) {
  while (i > 0 && (text[i - 1] == ' ' || text[i - 1] == '\t')) --i;
  return i == 0 || text[i - 1] == '\n';
}

/// The end of the comment, literal or directive at i, or i if there is none.
std::size_t end_of_blank(const std::string& text, std::size_t i) {
  if (text.compare(i, 2, "//") == 0) return std::min(text.size(), text.find('\n', i));
  if (text.compare(i, 2, "/*") == 0) return std::min(text.size(), text.find("*/", i) + 2);
  if (text[i] == '"' || text[i] == '\'') return end_of_literal(text, i);
  if (text[i] == '#' && starts_line(text, i)) return end_of_directive(text, i);
  return i;
}

enum class Brace : unsigned char { scope, function, block };

/// Without "template <...>" and access labels at its start.
std::string bare_head(std::string head) {
  for (bool again = true; again;) {
    again = false;
    head.erase(0, head.find_first_not_of(" \n\t"));
    for (const char* label : {"public:", "private:", "protected:"}) {
      if (head.rfind(label, 0) == 0) head.erase(0, std::string(label).size()), again = true;
    }
    if (head.rfind("template", 0) == 0) {
      std::size_t i = head.find('<');
      for (int depth = 0; i < head.size(); ++i) {
        depth += head[i] == '<' ? 1 : head[i] == '>' ? -1 : 0;
        if (depth == 0) break;
      }
      head.erase(0, i + 1), again = true;
    }
  }
  return head;
}

/// What a brace outside of functions opens, told by the text since the last statement.
Brace kind_of(const std::string& whole_head) {
  const std::string head = bare_head(whole_head);
  for (const char* word : {"namespace", "class", "struct", "union", "enum", "extern"}) {
    if (head.rfind(word, 0) == 0) return Brace::scope;
  }
  const std::size_t parenthesis = head.find('(');
  if (parenthesis == std::string::npos || contains_word(head, "concept")) return Brace::block;
  const std::size_t initializers = head.find(':', head.rfind(')', head.find(" : ")));
  const std::size_t last = head.find_last_not_of(" \n\t");
  const bool in_initializers = initializers != std::string::npos && head.find(" : ") != std::string::npos;
  if (in_initializers && is_word(head[last])) return Brace::block;
  if (head.find('=') < parenthesis && head.find("operator") == std::string::npos) return Brace::block;
  return Brace::function;
}

std::string name_of(const std::string& whole_head) {
  const std::string head = bare_head(whole_head);
  const std::size_t end = head.find('(');
  std::size_t begin = end;
  while (begin > 0 && (is_word(head[begin - 1]) || head[begin - 1] == ':' || head[begin - 1] == '~')) --begin;
  return head.substr(begin, end - begin);
}

/// Walks the blanked text brace by brace and collects what kind_of calls a function.
struct Walker {
  const std::string& text;
  std::vector<Brace> open = {};
  std::string head = {};
  std::size_t line = 1, head_line = 1, functions_open = 0;
  int parentheses = 0;
  Function current = {};
  std::vector<Function> found = {};

  void enter() {
    const Brace kind = functions_open > 0 || parentheses > 0 ? Brace::block : kind_of(head);
    open.push_back(kind);
    if (kind == Brace::function) {
      ++functions_open;
      current = {name_of(head), head_line, 0, false};
    }
    if (kind != Brace::block) head.clear();
  }

  void leave() {
    const Brace kind = open.empty() ? Brace::block : open.back();
    if (!open.empty()) open.pop_back();
    if (kind == Brace::function) {
      --functions_open;
      current.lines = line - current.first_line + 1;
      found.push_back(current);
    }
    if (kind != Brace::block) head.clear();
  }

  void step(char c) {
    if (c == '\n') ++line;
    if (c == '{') return enter();
    if (c == '}') return leave();
    if (functions_open > 0) return;
    parentheses += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == ';' && parentheses == 0) return head.clear();
    if (head.empty() && is_space(c)) return;
    if (head.empty()) head_line = line;
    head += c;
  }

  std::vector<Function> walk() {
    for (char c : text) step(c);
    return found;
  }
};

/// Offsets of the line starts, one more than there are lines.
std::vector<std::size_t> line_starts(const std::string& text) {
  std::vector<std::size_t> starts = {0, 0};  // lines count from 1
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') starts.push_back(i + 1);
  }
  starts.push_back(text.size());
  return starts;
}

}  // namespace

std::string blank_comments_and_literals(const std::string& text) {
  std::string blanked = text;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = std::min(text.size(), std::max(i + 1, end_of_blank(text, i)));
    if (end_of_blank(text, i) > i) {
      std::replace_if(
          blanked.begin() + static_cast<std::ptrdiff_t>(i),
          blanked.begin() + static_cast<std::ptrdiff_t>(end), [](char c) { return c != '\n'; }, ' ');
    }
    i = end;
  }
  return blanked;
}

std::vector<Function> functions_of(const std::string& text) {
  const std::string blanked = blank_comments_and_literals(text);
  std::vector<Function> functions = Walker{blanked}.walk();
  const std::vector<std::size_t> starts = line_starts(text);
  for (Function& f : functions) {
    const std::size_t from =
        starts[std::max<std::size_t>(1, f.first_line - std::min<std::size_t>(f.first_line, 3))];
    const std::size_t to = starts[f.first_line + f.lines];
    f.excused = text.substr(from, to - from).find("// long:") != std::string::npos;
  }
  return functions;
}

bool contains_word(const std::string& text, const std::string& word) {
  for (std::size_t i = text.find(word); i != std::string::npos; i = text.find(word, i + 1)) {
    const bool starts = i == 0 || !is_word(text[i - 1]);
    const bool ends = i + word.size() >= text.size() || !is_word(text[i + word.size()]);
    if (starts && ends) return true;
  }
  return false;
}

}  // namespace house
