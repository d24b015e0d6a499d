/**
 * The frame of the window and what lies over it.
 *
 * <p>{@link tellosimulator.view.layout.SimulatorPane} gives each part its place. {@link
 * tellosimulator.view.layout.WindowKey} is the table of the window's keys, with which {@link
 * tellosimulator.view.layout.KeyBindings} acts and which {@link
 * tellosimulator.view.layout.HelpPage} shows. {@link tellosimulator.view.layout.WindowCommands} is
 * the table of all that the window can do, for its menu and its palette of commands; that, help and
 * {@link tellosimulator.view.layout.AboutPage} lie over the window in {@link
 * tellosimulator.view.layout.PageOverlay}. Everything is for the JavaFX thread. What the parts show
 * is not its job.
 */
package tellosimulator.view.layout;
