package tellosimulator.words;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Says in another language what was kept as an English text, as in a recording: finds the template
 * that the text was made of, and the values in it. A text that is of no template stays as it is.
 * Not thread-safe, because it remembers what it has found.
 */
public final class Retranslation {

  private static final Pattern PLACE = Pattern.compile("%(?:,?(?:\\.\\d)?([sdf])|%)");

  /** Longer texts stay as they are. Decided: no sentence of the program is as long. */
  private static final int LONGEST = 600;

  /** A template, and how texts that are made of it look. */
  private record Form(String template, String kinds, Pattern pattern, String longest, int letters) {

    static Form of(String template) {
      StringBuilder regex = new StringBuilder();
      StringBuilder kinds = new StringBuilder();
      List<String> pieces = new ArrayList<>();
      Matcher place = PLACE.matcher(template);
      int end = 0;
      while (place.find()) {
        pieces.add(template.substring(end, place.start()));
        regex.append(Pattern.quote(pieces.get(pieces.size() - 1))).append(group(place));
        kinds.append(kind(template, place));
        end = place.end();
      }
      pieces.add(template.substring(end));
      regex.append(Pattern.quote(template.substring(end)));
      String longest = pieces.stream().max(Comparator.comparingInt(String::length)).orElse("");
      int letters = pieces.stream().mapToInt(String::length).sum();
      return new Form(
          template,
          kinds.toString(),
          Pattern.compile(regex.toString(), Pattern.DOTALL),
          longest,
          letters);
    }

    private static String group(Matcher place) {
      if (place.group(1) == null) {
        return "%";
      }
      return switch (place.group(1)) {
        case "d" -> "(-?[0-9,]{1,18})";
        case "f" -> "(-?[0-9]{1,15}(?:\\.[0-9]+)?)";
        default -> "(.+?)";
      };
    }

    /** What stands in backticks was written by others, and is a word in each language. */
    private static String kind(String template, Matcher place) {
      if (place.group(1) == null) {
        return "";
      }
      boolean quoted = place.start() > 0 && template.charAt(place.start() - 1) == '`';
      return quoted ? "q" : place.group(1);
    }
  }

  private final Translation translation;
  private final List<Form> forms;
  private final Map<String, String> known = new HashMap<>();

  public Retranslation(Translation translation) {
    this.translation = translation;
    forms =
        translation.templates().stream()
            .map(Form::of)
            .sorted(Comparator.comparingInt(Form::letters).reversed().thenComparing(Form::template))
            .toList();
  }

  /** What an English text says, in the other language. */
  public String of(String english) {
    if (forms.isEmpty() || english.length() > LONGEST) {
      return english;
    }
    String said = known.get(english);
    if (said == null) {
      said = found(english).orElse(english);
      known.put(english, said);
    }
    return said;
  }

  private Optional<String> found(String english) {
    for (Form form : forms) {
      if (form.letters() > 0 && english.contains(form.longest())) {
        Matcher matcher = form.pattern().matcher(english);
        if (matcher.matches()) {
          return Optional.of(said(form, matcher));
        }
      }
    }
    return Optional.empty();
  }

  private String said(Form form, Matcher matcher) {
    Object[] values = new Object[matcher.groupCount()];
    for (int i = 0; i < values.length; i++) {
      String text = matcher.group(i + 1);
      values[i] =
          switch (form.kinds().charAt(i)) {
            case 'd' -> Long.valueOf(text.replace(",", ""));
            case 'f' -> Double.valueOf(text);
            case 'q' -> text;
            default -> of(text);
          };
    }
    return Phrase.format(translation.locale(), translation.of(form.template()), values);
  }
}
