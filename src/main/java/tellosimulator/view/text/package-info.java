/**
 * The texts of the window in all its languages.
 *
 * <p>{@link tellosimulator.view.text.Language} is the chosen language; {@link
 * tellosimulator.view.text.Messages} provides the texts of one package of views. The texts follow
 * the language. Texts of the simulation are {@link tellosimulator.words.Phrase}s, which a {@link
 * tellosimulator.translation.PhraseCatalog} translates. Everything is confined to the JavaFX
 * thread. The package does not display the texts.
 */
package tellosimulator.view.text;
