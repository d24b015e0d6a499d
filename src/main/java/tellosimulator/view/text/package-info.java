/**
 * The texts of the window in the languages that it speaks.
 *
 * <p>{@link tellosimulator.view.text.Language} is the chosen language; {@link
 * tellosimulator.view.text.Messages} are the texts of one package of views, which change with it.
 * What the simulation says about itself are {@link tellosimulator.words.Phrase}s, which a {@link
 * tellosimulator.translation.PhraseCatalog} translates. Everything is for the JavaFX thread. Where
 * texts are shown is not its job.
 */
package tellosimulator.view.text;
