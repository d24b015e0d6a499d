package tellosimulator.words;

import java.util.Locale;

/** A language into which phrases can be translated. */
public interface Translation {

  /** The language of the templates. */
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

  /** Returns the translation of an English template, with the same format specifiers. */
  String of(String template);

  /** Returns the locale in which numbers are formatted. */
  Locale locale();
}
