"""What every part may use: files written whole, frozen mappings, plug-ins, arguments checked at the door."""
