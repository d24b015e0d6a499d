/**
 * What the window remembers from one start to the next.
 *
 * <p>{@link tellosimulator.view.settings.Settings} keeps properties in a file, each with a key and
 * a {@link tellosimulator.view.settings.SettingCodec} that says which values are allowed. {@link
 * tellosimulator.view.settings.WindowPlacement} is the size and place of a window. A file that is
 * damaged or cannot be written disturbs nobody: defaults, and a sentence in the log. Everything is
 * for the JavaFX thread. Options of the command line are not its job.
 */
package tellosimulator.view.settings;
