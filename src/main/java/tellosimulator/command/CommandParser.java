package tellosimulator.command;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tellosimulator.profile.Profile;
import tellosimulator.words.Phrase;
import tellosimulator.words.Spelling;

/** Finds the row of the command table that matches a text. Immutable. */
final class CommandParser {

  /** A verb directly followed by a number. */
  private static final Pattern VERB_AND_NUMBER = Pattern.compile("([A-Za-z]+)(-?[0-9].*)");

  private final Profile profile;
  private final Map<String, List<CommandSyntax>> byFirstWord;

  CommandParser(Profile profile) {
    this.profile = profile;
    byFirstWord =
        Stream.of(CommandSyntax.values())
            .filter(syntax -> syntax.knownTo(profile))
            .collect(Collectors.groupingBy(syntax -> words(syntax.verb()).get(0)));
  }

  /**
   * A text that has the form of a command. Its values may be out of range.
   *
   * @param arguments the words after the verb
   */
  record Parsed(CommandSyntax syntax, Arguments arguments, Profile profile) {

    Optional<Refusal> complaint() {
      return syntax.form().complaint(arguments, profile);
    }

    Command command() {
      return syntax.command(arguments);
    }
  }

  /** Returns the command in {@code text}; empty if the command is unknown. */
  Optional<Parsed> parse(String text) {
    if (text.length() > WireText.LONGEST) {
      return Optional.empty();
    }
    List<String> words = words(text);
    return byFirstWord.getOrDefault(words.get(0), List.of()).stream()
        .filter(syntax -> syntax.form().matches(words))
        .findFirst()
        .map(syntax -> new Parsed(syntax, syntax.form().arguments(words), profile));
  }

  /** Explains why {@code text} is unknown, worded to follow "refused: ". */
  Phrase explain(String text) {
    if (text.length() > WireText.LONGEST) {
      return Phrase.of("it is longer than %d bytes", WireText.LONGEST);
    }
    String first = words(text).get(0);
    List<CommandSyntax> candidates = byFirstWord.getOrDefault(first, List.of());
    if (!candidates.isEmpty()) {
      return Phrase.of(
          "expected %s, words separated by one blank and numbers in plain digits",
          candidates.stream()
              .map(syntax -> Phrase.of("`%s`", syntax.usage()))
              .reduce((one, other) -> Phrase.of("%s or %s", one, other))
              .orElseThrow());
    }
    if (first.isEmpty()) {
      return text.isEmpty() ? Phrase.of("it is empty") : Phrase.of("it begins with a blank");
    }
    return byFirstWord.keySet().stream()
        .filter(verb -> verb.equalsIgnoreCase(first))
        .findFirst()
        .map(verb -> Phrase.of("this command is written `%s`", verb))
        .or(() -> otherProfiles(first))
        .or(() -> meant(text, first))
        .orElse(Phrase.of("there is no such command"));
  }

  /** Suggests a command if the verb is misspelt, or if the space after the verb is missing. */
  private Optional<Phrase> meant(String text, String first) {
    Matcher parts = VERB_AND_NUMBER.matcher(first);
    boolean glued = parts.matches();
    String verb = glued ? parts.group(1) : first;
    String number = glued ? " " + parts.group(2) : "";
    return Spelling.meant(verb, byFirstWord.keySet())
        .map(known -> known + number + text.substring(first.length()))
        .map(WireText::printable)
        .map(guess -> Phrase.of("there is no such command, did you mean `%s`?", guess));
  }

  /** Names the SDK that introduced a verb, if another product knows the verb. */
  private static Optional<Phrase> otherProfiles(String verb) {
    return Stream.of(CommandSyntax.values())
        .filter(syntax -> syntax.firstWord().equals(verb))
        .map(CommandSyntax::since)
        .min(Comparator.naturalOrder())
        .map(
            since ->
                Phrase.of("this drone does not know it, it came with SDK %s", since.version()));
  }

  /** Splits a text at single spaces. Two consecutive spaces enclose an empty word. */
  private static List<String> words(String text) {
    List<String> words = new ArrayList<>();
    int start = 0;
    for (int blank = text.indexOf(' '); blank >= 0; blank = text.indexOf(' ', start)) {
      words.add(text.substring(start, blank));
      start = blank + 1;
    }
    words.add(text.substring(start));
    return words;
  }
}
