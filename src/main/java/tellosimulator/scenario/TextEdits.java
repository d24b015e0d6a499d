package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** Changes of a text, made all at once; whatever none of them touches stays as it is. */
final class TextEdits {

  private record Edit(int start, int end, String replacement) {}

  private final String text;
  private final String lineBreak;
  private final List<Edit> edits = new ArrayList<>();

  TextEdits(String text) {
    this.text = text;
    int first = text.indexOf('\n');
    this.lineBreak = first > 0 && text.charAt(first - 1) == '\r' ? "\r\n" : "\n";
  }

  String text() {
    return text;
  }

  void replace(int start, int end, String replacement) {
    edits.add(new Edit(start, end, replacement));
  }

  void replace(int start, int end, List<String> lines) {
    replace(start, end, String.join(lineBreak, lines));
  }

  void remove(int start, int end) {
    replace(start, end, "");
  }

  void insert(int at, String inserted) {
    replace(at, at, inserted);
  }

  /**
   * Inserts lines above the one that begins at an offset, or at the end of the text.
   *
   * @param at of the beginning of a line, or the end of the text
   */
  void insertLines(int at, List<String> lines) {
    boolean open = at == text.length() && !text.isEmpty() && !endsLine(at);
    String joined = String.join(lineBreak, lines);
    insert(at, open ? lineBreak + joined : joined + lineBreak);
  }

  /** Inserts lines where something begins, which goes on at the same column below them. */
  void insertAbove(int at, List<String> lines) {
    String next = lineBreak + " ".repeat(column(at));
    insert(at, String.join(next, lines) + next);
  }

  /**
   * Removes whole lines.
   *
   * @param start where the first one begins
   * @param end where the one behind the last begins, or the end of the text
   */
  void removeLines(int start, int end) {
    boolean open = end == text.length() && !endsLine(end) && start > 0;
    remove(open ? beforeLineBreak(start) : start, end);
  }

  private boolean endsLine(int at) {
    return at > 0 && text.charAt(at - 1) == '\n';
  }

  private int beforeLineBreak(int lineStart) {
    int end = lineStart - 1;
    return end > 0 && text.charAt(end - 1) == '\r' ? end - 1 : end;
  }

  // --- lines ---

  /** Where the line of an offset begins. */
  int lineStart(int at) {
    return text.lastIndexOf('\n', at - 1) + 1;
  }

  /** Where the line below that of an offset begins, or the end of the text. */
  int nextLine(int at) {
    int end = text.indexOf('\n', at);
    return end < 0 ? text.length() : end + 1;
  }

  /** The line of an offset, without what ends it. */
  String line(int at) {
    return text.substring(lineStart(at), nextLine(at)).stripTrailing();
  }

  /** How far a line is indented; its length, if it is empty. */
  int indent(int at) {
    String line = line(at);
    int indent = 0;
    while (indent < line.length() && line.charAt(indent) == ' ') {
      indent++;
    }
    return indent;
  }

  int column(int at) {
    return at - lineStart(at);
  }

  /** Whether only space is before an offset in its line. */
  boolean beginsLine(int at) {
    return text.substring(lineStart(at), at).isBlank();
  }

  boolean isBlank(int at) {
    return line(at).isBlank();
  }

  boolean isComment(int at) {
    return line(at).strip().startsWith("#");
  }

  /** The text with all changes; empty if two of them are in each other's way. */
  Optional<String> result() {
    List<Edit> sorted = new ArrayList<>(edits);
    sorted.sort(Comparator.comparingInt(Edit::start).thenComparingInt(Edit::end));
    StringBuilder result = new StringBuilder();
    int done = 0;
    for (Edit edit : sorted) {
      if (edit.start() < done && !edit.replacement().isEmpty()) {
        return Optional.empty();
      }
      result.append(text, done, Math.max(done, edit.start())).append(edit.replacement());
      done = Math.max(done, edit.end());
    }
    return Optional.of(result.append(text, done, text.length()).toString());
  }
}
