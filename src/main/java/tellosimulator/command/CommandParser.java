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

/** Finds the row of the table that a text is written after. Immutable; for any thread. */
final class CommandParser {

  /** A verb and a number without a blank between them. */
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
   * A text that is a command, though its values may be out of range.
   *
   * @param arguments the words after the verb
   */
  record Parsed(CommandSyntax syntax, Arguments arguments, Profile profile) {

    Optional<Refusal> complaint() {
      return syntax.complaint(arguments, profile);
    }

    Command command() {
      return syntax.command(arguments);
    }
  }

  /** The command that {@code text} is; empty if it is unknown. */
  Optional<Parsed> parse(String text) {
    if (text.length() > WireText.LONGEST) {
      return Optional.empty();
    }
    List<String> words = words(text);
    return byFirstWord.getOrDefault(words.get(0), List.of()).stream()
        .filter(syntax -> syntax.matches(words))
        .findFirst()
        .map(syntax -> new Parsed(syntax, syntax.arguments(words), profile));
  }

  /** Why {@code text} is unknown, in plain words that follow "refused: ". */
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

  /** What somebody may have meant who misspelt the verb, or forgot the blank behind it. */
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

  /** Which products would know a verb. */
  private static Optional<Phrase> otherProfiles(String verb) {
    return Stream.of(CommandSyntax.values())
        .filter(syntax -> syntax.firstWord().equals(verb))
        .map(CommandSyntax::since)
        .min(Comparator.naturalOrder())
        .map(
            since ->
                Phrase.of("this drone does not know it, it came with SDK %s", since.version()));
  }

  /** The words between single blanks; two blanks in a row give an empty word. */
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
