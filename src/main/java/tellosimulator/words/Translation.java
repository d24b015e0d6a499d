package tellosimulator.words;

import java.util.Locale;
import java.util.Set;

/** A language that phrases can be said in. */
public interface Translation {

  /** As the phrases are written. */
  Translation ENGLISH =
      new Translation() {
        @Override
        public String of(String template) {
          return template;
        }

        @Override
        public Locale locale() {
          return Locale.ROOT;
        }
      };

  /** The template that stands for an English one; the same places for values are in it. */
  String of(String template);

  /** The English templates for which there is another one. */
  default Set<String> templates() {
    return Set.of();
  }

  /** After whose customs numbers are written. */
  Locale locale();
}
