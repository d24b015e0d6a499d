/**
 * Translatable messages for users.
 *
 * <p>A {@link tellosimulator.words.Phrase} is an English template with values, created where an
 * event happens. A phrase can format itself in English, or in another language with a {@link
 * tellosimulator.words.Translation}. All types are immutable. The package imports no other package
 * of the project. Texts that a drone sends on the wire are not phrases. Another package contains
 * the other languages.
 */
package tellosimulator.words;
