/**
 * The settings that the window keeps from one start to the next.
 *
 * <p>{@link tellosimulator.view.settings.Settings} stores properties in a file, each with a key and
 * a {@link tellosimulator.view.settings.SettingCodec} that defines the allowed values. {@link
 * tellosimulator.view.settings.WindowPlacement} restores the size and position of a window. A file
 * that is damaged or cannot be written never stops the program: defaults apply, and a sentence is
 * logged. Everything is confined to the JavaFX thread. Command-line options are handled elsewhere.
 */
package tellosimulator.view.settings;
