package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import tellosimulator.scenario.SyntaxTree.Collection;
import tellosimulator.scenario.SyntaxTree.Element;

/**
 * Takes elements out of one list or mapping of a text, and puts others in. Comments stay with what
 * they are about: those behind an element, and those on the lines directly above it, without an
 * empty line between, go when it goes; but not an element that was made a comment.
 */
final class ElementEdits {

  /** A list item that was made a comment. */
  private static final String COMMENTED_ITEM = "#\\s*-\\s.*";

  private final TextEdits edits;
  private final Collection collection;
  private final List<Element> elements;
  private final boolean[] removed;

  ElementEdits(TextEdits edits, Collection collection) {
    this.edits = edits;
    this.collection = collection;
    this.elements = collection.elements();
    this.removed = new boolean[elements.size()];
  }

  /** Takes one out; to be called before {@link #add}. */
  void remove(int index) {
    removed[index] = true;
    if (!collection.flow()) {
      removeFromBlock(index);
    } else if (hasOwnLines(index)) {
      edits.removeLines(attached(index), edits.nextLine(elements.get(index).end()));
    } else {
      removeFromFlow(index);
    }
  }

  private void removeFromFlow(int index) {
    Element element = elements.get(index);
    int before = keptBefore(index);
    if (before >= 0) {
      edits.remove(elements.get(index - 1).end(), element.end());
    } else if (index + 1 < elements.size()) {
      edits.remove(element.start(), elements.get(index + 1).start());
    } else {
      boolean comma = edits.text().startsWith(",", element.end()); // which none may stand behind
      edits.remove(element.start(), element.end() + (comma ? 1 : 0));
    }
  }

  private void removeFromBlock(int index) {
    Element element = elements.get(index);
    if (!edits.beginsLine(lead(index))) { // it is behind the dash of the item that it belongs to
      edits.remove(element.start(), elements.get(index + 1).start());
      return;
    }
    int start = attached(index);
    int end = blockEnd(index);
    boolean gap = end == edits.text().length() || edits.isBlank(end);
    while (gap && start > 0 && edits.isBlank(start - 1)) {
      start = edits.lineStart(start - 1);
    }
    edits.removeLines(start, end);
  }

  /**
   * Puts elements in.
   *
   * @param slot before which element; their number for the end
   * @param inline what they are in one line
   * @param lines what they are on lines of their own, without indentation
   */
  void add(int slot, List<String> inline, List<String> lines) {
    if (!collection.flow()) {
      addToBlock(slot, lines);
    } else {
      addToFlow(slot, inline);
    }
  }

  private void addToFlow(int slot, List<String> inline) {
    String joined = String.join(", ", inline);
    int before = keptBefore(slot);
    int after = keptFrom(slot);
    if (before >= 0 && hasOwnLines(before)) {
      addBelow(before, inline);
    } else if (before >= 0) {
      edits.insert(elements.get(slot - 1).end(), ", " + joined);
    } else if (after >= 0) {
      edits.insert(elements.get(after).start(), joined + ", ");
    } else {
      int inside = elements.isEmpty() ? collection.end() - 1 : elements.get(0).start();
      edits.insert(inside, joined);
    }
  }

  /** Adds lines to a list in brackets that has its items on lines of their own. */
  private void addBelow(int before, List<String> inline) {
    Element element = elements.get(before);
    boolean comma = edits.text().startsWith(",", element.end());
    if (!comma) {
      edits.insert(element.end(), ",");
    }
    String indent = " ".repeat(edits.column(element.start()));
    List<String> lines = new ArrayList<>();
    for (String each : inline) {
      boolean last = lines.size() == inline.size() - 1;
      lines.add(indent + each + (last && !comma ? "" : ","));
    }
    edits.insertLines(edits.nextLine(element.end()), lines);
  }

  private void addToBlock(int slot, List<String> lines) {
    if (slot > 0) {
      String indent = " ".repeat(column());
      edits.insertLines(
          blockEnd(slot - 1),
          lines.stream().map(line -> line.isEmpty() ? line : indent + line).toList());
      return;
    }
    int above = edits.beginsLine(lead(0)) ? attached(0) : 0;
    // what stands at the top of a file is about all of it
    int place = above > 0 ? above + column() : lead(0);
    List<String> reordered = new ArrayList<>(lines);
    Collections.rotate(reordered, lines.get(0).isEmpty() ? -1 : 0); // the empty line goes below
    edits.insertAbove(place, reordered);
  }

  // --- where elements are ---

  /** Column of keys, or of dashes. */
  int column() {
    return edits.column(lead(0));
  }

  /** Where an element begins, with its dash. */
  private int lead(int index) {
    Element element = elements.get(index);
    if (collection.flow() || element.key().isPresent()) {
      return element.start();
    }
    int line =
        index == 0
            ? edits.lineStart(collection.start())
            : edits.nextLine(elements.get(index - 1).end());
    while (line < element.start() && !edits.line(line).strip().startsWith("-")) {
      line = edits.nextLine(line);
    }
    int dash = edits.text().indexOf('-', line);
    return dash < 0 ? element.start() : dash;
  }

  /** Where the lines of an element begin, with the comments above it. */
  private int attached(int index) {
    int start = edits.lineStart(lead(index));
    int indent = edits.indent(start);
    while (start > 0) {
      int above = edits.lineStart(start - 1);
      boolean its = edits.isComment(above) && edits.indent(above) == indent;
      if (!its || edits.line(above).strip().matches(COMMENTED_ITEM)) {
        break;
      }
      start = above;
    }
    return start;
  }

  /** Where the lines of an element end, with the comments below it that are indented deeper. */
  private int blockEnd(int index) {
    int column = column();
    int end = edits.nextLine(elements.get(index).end());
    while (end < edits.text().length() && edits.isComment(end) && edits.indent(end) > column) {
      end = edits.nextLine(end);
    }
    return end;
  }

  /** Whether nothing but an element, its comma and a comment is on its lines. */
  private boolean hasOwnLines(int index) {
    Element element = elements.get(index);
    int end = element.end();
    String rest = edits.text().substring(end, edits.nextLine(end)).strip();
    return edits.beginsLine(element.start()) && (rest.isEmpty() || rest.matches(",?\\s*(#.*)?"));
  }

  private int keptBefore(int index) {
    int kept = index - 1;
    while (kept >= 0 && removed[kept]) {
      kept--;
    }
    return kept;
  }

  private int keptFrom(int index) {
    int kept = index;
    while (kept < removed.length && removed[kept]) {
      kept++;
    }
    return kept < removed.length ? kept : -1;
  }
}
