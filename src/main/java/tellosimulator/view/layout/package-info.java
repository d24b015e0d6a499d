/**
 * The frame of the window and the pages over it.
 *
 * <p>{@link tellosimulator.view.layout.SimulatorPane} arranges the parts. {@link
 * tellosimulator.view.layout.WindowKey} is the table of the window's keys. {@link
 * tellosimulator.view.layout.KeyBindings} binds the keys to actions, and {@link
 * tellosimulator.view.layout.HelpPage} lists the keys. {@link
 * tellosimulator.view.layout.WindowCommands} is the table of all commands, for the menu and the
 * command palette. {@link tellosimulator.view.layout.PageOverlay} shows the palette, the help,
 * {@link tellosimulator.view.layout.AboutPage} and other pages over the window. Everything is
 * confined to the JavaFX thread. The package is not responsible for the content of the parts.
 */
package tellosimulator.view.layout;
