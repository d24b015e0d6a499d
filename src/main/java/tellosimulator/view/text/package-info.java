/**
 * The texts of the window in the languages that it speaks.
 *
 * <p>{@link tellosimulator.view.text.Language} is the chosen language; {@link
 * tellosimulator.view.text.Messages} are the texts of one package of views, which change with it.
 * Everything is for the JavaFX thread. What is said in the log is said by {@code view.log}.
 */
package tellosimulator.view.text;
