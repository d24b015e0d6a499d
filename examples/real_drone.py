"""A flight with djitellopy as one writes it for a real Tello: nothing in it knows of the simulator.

With a real one, join its network and start it. With the simulator, on Linux:

    pip install djitellopy
    java -jar target/tello-simulator.jar run --headless -- python examples/real_drone.py

On Windows and macOS `docker compose up --exit-code-from program` does the same.
"""

from djitellopy import Tello

tello = Tello()
tello.connect()
print("Battery:", tello.get_battery(), "%")
tello.takeoff()
try:
    for _ in range(4):
        tello.move_forward(50)
        tello.rotate_clockwise(90)
finally:
    tello.land()
print("Flew", tello.get_flight_time(), "s.")
